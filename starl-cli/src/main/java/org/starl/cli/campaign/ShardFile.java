package org.starl.cli.campaign;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.function.Predicate;
import org.starl.cli.command.OutputFile;
import org.starl.input.BadInput;
import org.starl.input.FailureText;

/**
 * The file of a shard: a header, then a row for each run in order. Each row is appended as soon
 * as its run and all before it have ended, so a killed process leaves whole rows and at most one
 * incomplete line, from which {@link #resume} continues.
 */
final class ShardFile implements Closeable {

  private static final String OPTION = "--out";

  private final String name;
  // Not a channel: a signal interrupts the thread, and an interrupt closes a channel.
  private final OutputStream out;

  private ShardFile(String name, long wholeBytes) {
    this.name = name;
    try {
      Path folder = Path.of(name).toAbsolutePath().getParent();
      if (folder != null) {
        Files.createDirectories(folder);
      }
      Path path = Path.of(name);
      try (FileChannel rows =
          FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
        rows.truncate(wholeBytes);
      }
      out = Files.newOutputStream(path, StandardOpenOption.APPEND);
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
   * @param rows gets each whole row; false if one before it is missing
   * @throws BadInput if it is of another work or shard, is damaged, or cannot be written
   */
  static <R> ShardFile resume(String name, ShardHeader header, ShardWork<R> work, Predicate<R> rows)
      throws IOException {
    if (length(name) == 0) {
      return create(name, header);
    }
    Shard shard = header.shard(name, work);
    long wholeBytes;
    try (ShardReader reader = new ShardReader(name)) {
      String first = reader.line();
      if (first != null) {
        ShardHeader old = ShardHeader.read(name, first);
        old.requireSameWork(name, header);
        if (!old.part().equals(header.part())) {
          throw new BadInput(
              name + ":1: shard: " + old.part() + ": expected " + header.part() + ", to resume");
        }
        for (ShardReader.Line<R> line = reader.row(work, shard);
            line != null;
            line = reader.row(work, shard)) {
          if (!rows.test(line.row())) {
            throw new BadInput(
                "%s%s: %s: expected all before it"
                    .formatted(reader.where(), work.unit(), ShardReader.text(line.place())));
          }
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

  void append(String line) throws IOException {
    try {
      out.write((line + "\n").getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new IOException(
          OPTION + ": " + BadInput.quote(name) + ": cannot be written (" + FailureText.of(e) + ")",
          e);
    }
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
