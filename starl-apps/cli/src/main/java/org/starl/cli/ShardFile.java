package org.starl.cli;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.function.Consumer;
import org.starl.cli.report.SeedRow;
import org.starl.input.BadInput;

/**
 * The file of a shard: a header, then a row for each run in seed order. Each row is appended as soon
 * as its run and all before it have ended, so a killed process leaves whole rows and at most one
 * incomplete line, from which {@link #resume} continues.
 */
final class ShardFile implements Closeable {

  private static final String OPTION = "--out";

  private final String name;
  private final FileChannel channel;

  private ShardFile(String name, long wholeBytes) {
    this.name = name;
    try {
      Path folder = Path.of(name).toAbsolutePath().getParent();
      if (folder != null) {
        Files.createDirectories(folder);
      }
      channel =
          FileChannel.open(Path.of(name), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
      channel.truncate(wholeBytes).position(wholeBytes);
    } catch (IOException | InvalidPathException e) {
      throw OutputFile.unwritable(OPTION, name, e);
    }
  }

  /**
   * Begins a file.
   *
   * @throws BadInput if there is one already, or it cannot be written
   */
  static ShardFile create(String name, ShardHeader header) throws IOException {
    if (length(name) > 0) {
      throw new BadInput(
          OPTION
              + ": "
              + BadInput.quote(name)
              + ": exists already; expected --resume, or another name");
    }
    ShardFile file = new ShardFile(name, 0);
    file.append(header.line());
    return file;
  }

  private static long length(String name) throws IOException {
    try {
      Path path = Path.of(name);
      return Files.isRegularFile(path) ? Files.size(path) : 0;
    } catch (InvalidPathException e) {
      throw new BadInput(OPTION + ": " + BadInput.quote(name) + ": expected a file's name");
    }
  }

  /**
   * Continues a file after its whole rows; begins it if there is none.
   *
   * @param rows gets each whole row
   * @throws BadInput if it is of another campaign or shard, is damaged, or cannot be written
   */
  static ShardFile resume(String name, ShardHeader header, String key, Consumer<SeedRow> rows)
      throws IOException {
    if (length(name) == 0) {
      return create(name, header);
    }
    Seeds.Range seeds = header.shard().seeds(header.range());
    long wholeBytes;
    try (ShardReader reader = new ShardReader(name)) {
      String first = reader.line();
      if (first != null) {
        ShardHeader old = ShardHeader.read(name, first);
        old.requireSameCampaign(name, header);
        if (!old.shard().equals(header.shard())) {
          throw new BadInput(
              name + ":1: shard: " + old.shard() + ": expected " + header.shard() + ", to resume");
        }
        long next = seeds.first();
        for (String line = reader.line(); line != null; line = reader.line()) {
          SeedRow row = SeedRow.of(reader.where(), line);
          reader.require(row, key, new Seeds.Range(next, seeds.last()));
          rows.accept(row);
          next++;
        }
      }
      wholeBytes = reader.wholeBytes();
    }
    ShardFile file = new ShardFile(name, wholeBytes);
    if (wholeBytes == 0) {
      file.append(header.line());
    }
    return file;
  }

  void append(SeedRow row) throws IOException {
    append(row.line());
  }

  private void append(String line) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap((line + "\n").getBytes(StandardCharsets.UTF_8));
    try {
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
    } catch (IOException e) {
      throw new IOException(
          OPTION + ": " + BadInput.quote(name) + ": cannot be written (" + e.getMessage() + ")", e);
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
