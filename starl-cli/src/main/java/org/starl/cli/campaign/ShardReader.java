package org.starl.cli.campaign;

import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.input.TextFile;

/**
 * Reads a shard's file line by line. Its last line may be incomplete, if the writer was killed: it
 * does not count.
 */
final class ShardReader implements Closeable {

  /** A row of a run is some kilobytes. */
  private static final int MAX_LINE_BYTES = 64 << 20;

  private static final int BUFFER_BYTES = 1 << 13;

  private static final String EXPECTED = "expected a file of 'starl campaign --out'";

  /** The order of the places of rows. */
  static final Comparator<List<Long>> PLACES =
      Comparator.<List<Long>>comparingInt(List::size)
          .thenComparing((one, other) -> {
            int i = 0;
            while (i < one.size() - 1 && one.get(i).equals(other.get(i))) {
              i++;
            }
            return one.isEmpty() ? 0 : Long.compare(one.get(i), other.get(i));
          });

  private final String name;
  private final InputStream in;
  private final byte[] buffer = new byte[BUFFER_BYTES];
  private int next;
  private int filled;
  private long wholeBytes;
  private int lines;
  private @Nullable List<Long> last;

  /**
   * @throws BadInput if it cannot be read
   */
  ShardReader(String name) {
    this.name = name;
    try {
      in = TextFile.open(Path.of(name), EXPECTED);
    } catch (InvalidPathException e) {
      throw new BadInput(name + ": cannot be read (" + FailureText.of(e) + "); " + EXPECTED);
    }
  }

  String name() {
    return name;
  }

  /** The place of the last line read, for errors: {@code part-3:17: }. */
  String where() {
    return name + ":" + lines + ": ";
  }

  /** The length of the whole lines read so far, in bytes. */
  long wholeBytes() {
    return wholeBytes;
  }

  /** The next whole line; null at the end. */
  @Nullable String line() throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    int end = newline();
    while (end == filled) {
      line.write(buffer, next, end - next);
      if (line.size() > MAX_LINE_BYTES) {
        throw new BadInput(name + ": expected lines of at most " + MAX_LINE_BYTES + " bytes");
      }
      next = 0;
      filled = Math.max(0, in.read(buffer));
      if (filled == 0) {
        return null;
      }
      end = newline();
    }
    line.write(buffer, next, end - next);
    next = end + 1;
    lines++;
    wholeBytes += line.size() + 1L;
    return line.toString(StandardCharsets.UTF_8);
  }

  /** The place of the next end of a line in the buffer; {@code filled} if there is none. */
  private int newline() {
    int i = next;
    while (i < filled && buffer[i] != '\n') {
      i++;
    }
    return i;
  }

  /**
   * The next row, of a shard of {@code work}; null at the end.
   *
   * @throws BadInput if it is none, is not in {@code shard}, or does not come after the row before
   *     it
   */
  <R> @Nullable Line<R> row(ShardWork<R> work, Shard shard) throws IOException {
    String line = line();
    if (line == null) {
      return null;
    }
    R row = work.row(where(), line);
    List<Long> place = work.place(row);
    boolean isNext = last == null || PLACES.compare(last, place) < 0;
    if (!isNext || !work.owns(shard, place)) {
      throw new BadInput(
          "%s%s: %s: expected those of shard %s in order"
              .formatted(where(), work.unit(), text(place), shard));
    }
    last = place;
    return new Line<>(row, place, line);
  }

  /** A row that was read. */
  record Line<R>(R row, List<Long> place, String text) {}

  /** {@code 17}, or {@code 3.7}. */
  static String text(List<Long> place) {
    return place.stream().map(String::valueOf).collect(Collectors.joining("."));
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
