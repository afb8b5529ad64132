package org.starl.cli;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.Closeable;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.starl.apps.Demos;
import org.starl.cli.report.SeedRow;
import org.starl.input.BadInput;

/**
 * Reads the files of a campaign's shards at once, in seed order; one row of each file is in memory.
 * A seed may be in several files: its rows must be equal.
 */
final class ShardMerge implements Closeable {

  private static final int MOST_DIFFERENCES = 20;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** The next row of a file. */
  private record Next(ShardReader file, int index, SeedRow row, String line) {}

  private final List<ShardReader> files = new ArrayList<>();
  private final List<ShardHeader> headers = new ArrayList<>();
  private final RunRequest request;
  private final String key;
  private final List<String> differences = new ArrayList<>();

  private final PriorityQueue<Next> queue =
      new PriorityQueue<>(
          Comparator.comparingLong((Next next) -> next.row.seed()).thenComparing(Next::index));

  /**
   * Opens the files.
   *
   * @throws BadInput if one is not a shard's file of this version, or they are of different
   *     campaigns
   */
  ShardMerge(List<String> names, Demos demos) throws IOException {
    boolean isOpen = false;
    try {
      for (String name : names) {
        ShardReader file = new ShardReader(name);
        files.add(file);
        String first = file.line();
        headers.add(ShardHeader.read(name, first == null ? "" : first));
        headers.getLast().requireSameCampaign(name, headers.getFirst());
      }
      request = header().request(names.getFirst(), demos);
      key = ShardHeader.key(request);
      isOpen = true;
    } finally {
      if (!isOpen) {
        close();
      }
    }
  }

  /** That of the first file; all have the same campaign. */
  ShardHeader header() {
    return headers.getFirst();
  }

  RunRequest request() {
    return request;
  }

  /** A line for each of the first seeds whose rows differ. */
  List<String> differences() {
    return Collections.unmodifiableList(differences);
  }

  /**
   * Reads all rows.
   *
   * @param isLast gets each seed's row in seed order; after the first true no row is missed, and
   *     further rows are only compared
   * @throws BadInput if a seed is missing or a file is damaged
   */
  void read(Predicate<SeedRow> isLast) throws IOException {
    for (int i = 0; i < files.size(); i++) {
      advance(i);
    }
    long expected = header().range().first();
    boolean isOver = false;
    while (!queue.isEmpty()) {
      Next next = take();
      if (!isOver) {
        requireNoneMissing(expected, next.row.seed());
        isOver = isLast.test(next.row);
        expected++;
      }
    }
    if (!isOver) {
      requireNoneMissing(expected, header().range().last() + 1);
    }
  }

  /** The next seed's row. */
  private Next take() throws IOException {
    Next first = queue.remove();
    advance(first.index);
    for (Next other = queue.peek();
        other != null && other.row.seed() == first.row.seed();
        other = queue.peek()) {
      queue.remove();
      advance(other.index);
      if (!other.line.equals(first.line) && differences.size() < MOST_DIFFERENCES) {
        differences.add(difference(first, other));
      }
    }
    return first;
  }

  private void advance(int index) throws IOException {
    ShardReader file = files.get(index);
    String line = file.line();
    if (line != null) {
      SeedRow row = SeedRow.of(file.where(), line);
      ShardHeader header = headers.get(index);
      file.require(row, key, header.shard().seeds(header.range()));
      queue.add(new Next(file, index, row, line));
    }
  }

  private void requireNoneMissing(long expected, long found) {
    if (found == expected) {
      return;
    }
    String missing =
        found - 1 == expected ? "seed " + expected : "seeds " + expected + ".." + (found - 1);
    SortedSet<String> shards = new TreeSet<>();
    for (int i = 0; i < files.size(); i++) {
      ShardHeader header = headers.get(i);
      Seeds.Range seeds = header.shard().seeds(header.range());
      if (seeds.first() <= expected && expected <= seeds.last()) {
        shards.add(files.get(i).name());
      }
    }
    throw new BadInput(
        missing
            + " of "
            + header().range()
            + (found - 1 == expected ? " is missing: " : " are missing: ")
            + (shards.isEmpty()
                ? "expected the files of all shards"
                : "expected '--resume' to complete " + String.join(" or ", shards)));
  }

  private static String difference(Next one, Next other) {
    String where;
    try {
      where = difference("", MAPPER.readTree(one.line), MAPPER.readTree(other.line));
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a row that was read before", e);
    }
    return "determinism bug: seed %d has different rows in %s and %s%s"
        .formatted(one.row.seed(), one.file.name(), other.file.name(), where);
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
