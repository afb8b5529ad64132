package org.starl.cli;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.starl.cli.report.SeedRow;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/**
 * Reads a shard's file line by line. Its last line may be incomplete, if the writer was killed: it
 * does not count.
 */
final class ShardReader implements Closeable {

  /** A row of a run is some kilobytes. */
  private static final int MAX_LINE_BYTES = 64 << 20;

  private static final String EXPECTED = "expected a file of 'starl campaign --out'";

  private final String name;
  private final InputStream in;
  private long wholeBytes;
  private int lines;
  private long lastSeed = Long.MIN_VALUE;

  /**
   * @throws BadInput if it cannot be read
   */
  ShardReader(String name) {
    this.name = name;
    try {
      in = new BufferedInputStream(TextFile.open(Path.of(name), EXPECTED));
    } catch (InvalidPathException e) {
      throw new BadInput(name + ": cannot be read (" + e + "); " + EXPECTED);
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
    for (int b = in.read(); b != '\n'; b = in.read()) {
      if (b < 0) {
        return null;
      }
      line.write(b);
      if (line.size() > MAX_LINE_BYTES) {
        throw new BadInput(name + ": expected lines of at most " + MAX_LINE_BYTES + " bytes");
      }
    }
    lines++;
    wholeBytes += line.size() + 1L;
    return line.toString(StandardCharsets.UTF_8);
  }

  /**
   * Checks a row that was just read.
   *
   * @throws BadInput if its campaign is not {@code key}, it is not in {@code range}, or a row before
   *     it has a larger seed
   */
  void require(SeedRow row, String key, Seeds.Range range) {
    if (!row.key().equals(key)) {
      throw new BadInput(
          where() + "key: " + BadInput.quote(row.key()) + ": expected " + key + ", the campaign's");
    }
    if (row.seed() <= lastSeed || row.seed() < range.first() || row.seed() > range.last()) {
      throw new BadInput(
          where() + "seed: " + row.seed() + ": expected the seeds " + range + " in order");
    }
    lastSeed = row.seed();
  }

  @Override
  public void close() throws IOException {
    in.close();
  }
}
