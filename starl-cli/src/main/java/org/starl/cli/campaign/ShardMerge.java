package org.starl.cli.campaign;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.PriorityQueue;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.input.BadInput;

/**
 * Reads the files of shards at once, in the order of their rows; one row of each file is in memory.
 * A run may be in several files: its rows must be equal.
 */
final class ShardMerge implements Closeable {

  private static final int MOST_DIFFERENCES = 20;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final List<ShardReader> files = new ArrayList<>();
  private final List<ShardHeader> headers = new ArrayList<>();
  private final List<String> differences = new ArrayList<>();

  /**
   * Opens the files.
   *
   * @throws BadInput if one is not a shard's file of this version, or they are of different
   *     works
   */
  ShardMerge(List<String> names) throws IOException {
    boolean isOpen = false;
    try {
      for (String name : names) {
        ShardReader file = new ShardReader(name);
        files.add(file);
        String first = file.line();
        headers.add(ShardHeader.read(name, first == null ? "" : first));
        headers.getLast().requireSameWork(name, headers.getFirst());
      }
      isOpen = true;
    } finally {
      if (!isOpen) {
        close();
      }
    }
  }

  /** That of the first file; all have the same work. */
  ShardHeader header() {
    return headers.getFirst();
  }

  /** The work of all files. */
  ShardWork<?> work(Demos demos) {
    return header().work(files.getFirst().name(), demos);
  }

  /** A line for each of the first runs whose rows differ. */
  List<String> differences() {
    return Collections.unmodifiableList(differences);
  }

  /**
   * Reads all rows.
   *
   * @param isLast gets each run's row in order; after the first true no row is missed, and further
   *     rows are only compared
   * @return whether the last row of the whole was read
   * @throws BadInput if a row is missing or a file is damaged
   */
  <R> boolean read(ShardWork<R> work, Predicate<R> isLast) throws IOException {
    return new Reading<>(work).read(isLast);
  }

  /** The next row of a file. */
  private record Next<R>(int file, ShardReader.Line<R> line) {}

  private final class Reading<R> {

    private final ShardWork<R> work;
    private final List<Shard> shards = new ArrayList<>();

    private final PriorityQueue<Next<R>> queue =
        new PriorityQueue<>(
            Comparator.comparing((Next<R> next) -> next.line.place(), ShardReader.PLACES)
                .thenComparing(Next::file));

    Reading(ShardWork<R> work) {
      this.work = work;
      for (int i = 0; i < files.size(); i++) {
        shards.add(headers.get(i).shard(files.get(i).name(), work));
      }
    }

    boolean read(Predicate<R> isLast) throws IOException {
      for (int i = 0; i < files.size(); i++) {
        advance(i);
      }
      ShardWork.Sequence<R> whole = work.whole();
      boolean isOver = false;
      while (!queue.isEmpty()) {
        ShardReader.Line<R> line = take();
        if (!isOver) {
          requireNext(whole.next(), line.place());
          whole.take(line.row());
          isOver = isLast.test(line.row());
        }
      }
      if (!isOver) {
        requireNext(whole.next(), null);
      }
      return whole.next() == null;
    }

    /** The next row. */
    private ShardReader.Line<R> take() throws IOException {
      Next<R> first = queue.remove();
      advance(first.file);
      for (Next<R> other = queue.peek();
          other != null && other.line.place().equals(first.line.place());
          other = queue.peek()) {
        queue.remove();
        advance(other.file);
        if (!other.line.text().equals(first.line.text()) && differences.size() < MOST_DIFFERENCES) {
          differences.add(difference(first, other));
        }
      }
      return first.line;
    }

    private void advance(int file) throws IOException {
      ShardReader.Line<R> line = files.get(file).row(work, shards.get(file));
      if (line != null) {
        queue.add(new Next<>(file, line));
      }
    }

    private void requireNext(@Nullable List<Long> expected, @Nullable List<Long> found) {
      if (Objects.equals(expected, found)) {
        return;
      }
      if (expected == null) {
        String more = found == null ? "" : ShardReader.text(found);
        throw new BadInput("%s %s: expected no more".formatted(work.unit(), more));
      }
      SortedSet<String> owners = new TreeSet<>();
      for (int i = 0; i < files.size(); i++) {
        if (work.owns(shards.get(i), expected)) {
          owners.add(files.get(i).name());
        }
      }
      throw new BadInput(
          work.missing(expected, found)
              + " missing: "
              + (owners.isEmpty()
                  ? "expected the files of all shards"
                  : "expected '--resume' to complete " + String.join(" or ", owners)));
    }

    private String difference(Next<R> one, Next<R> other) {
      String where;
      try {
        where =
            ShardMerge.difference(
                "", MAPPER.readTree(one.line.text()), MAPPER.readTree(other.line.text()));
      } catch (JsonProcessingException e) {
        throw new IllegalStateException("a row that was read before", e);
      }
      return "determinism bug: %s %s has different rows in %s and %s%s"
          .formatted(
              work.unit(),
              ShardReader.text(one.line.place()),
              files.get(one.file).name(),
              files.get(other.file).name(),
              where);
    }
  }

  /** The first value that differs: {@code : outcome.figures.end_s: 12.3 and 12.4}. */
  private static String difference(String path, JsonNode one, JsonNode other) {
    if (one.isObject() && other.isObject()) {
      SortedSet<String> names = new TreeSet<>();
      one.properties().forEach(entry -> names.add(entry.getKey()));
      other.properties().forEach(entry -> names.add(entry.getKey()));
      for (String name : names) {
        if (!one.path(name).equals(other.path(name))) {
          return difference(
              path.isEmpty() ? name : path + "." + name, one.path(name), other.path(name));
        }
      }
    }
    return ": %s: %s and %s"
        .formatted(path, BadInput.quote(one.toString()), BadInput.quote(other.toString()));
  }

  @Override
  public void close() throws IOException {
    for (ShardReader file : files) {
      file.close();
    }
  }
}
