package org.starl.cli;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import org.starl.input.BadInput;

/**
 * A file that appears whole or not at all: what is written goes beside it, under a name of its own,
 * and takes its place when closed. If nothing was written, nothing changes. What is there already
 * and is no file (a terminal, a pipe) is written to as it is.
 */
final class OutputFile implements Closeable {

  private final Path target;
  private final Path written;
  private final Counted out;

  /**
   * @param option for errors: {@code --trace}
   */
  OutputFile(String option, String name) {
    try {
      Path path = Path.of(name).toAbsolutePath();
      boolean isDevice =
          Files.exists(path) && !Files.isRegularFile(path) && !Files.isDirectory(path);
      target = Files.isRegularFile(path) ? path.toRealPath() : path;
      Path folder = target.getParent();
      if (name.isEmpty() || folder == null || Files.isDirectory(target)) {
        throw new BadInput(option + ": " + BadInput.quote(name) + ": expected a file's name");
      }
      if (isDevice) {
        written = target;
        out = new Counted(Files.newOutputStream(target, StandardOpenOption.WRITE));
        return;
      }
      if (!Files.isDirectory(folder)) {
        Files.createDirectories(folder);
      }
      long process = ProcessHandle.current().pid();
      written = folder.resolve("." + target.getFileName() + "." + process + ".part");
      out = new Counted(create(option, name, written));
      // Where a person stops the run, nobody comes to close this.
      written.toFile().deleteOnExit();
    } catch (IOException | InvalidPathException e) {
      throw new BadInput(
          option
              + ": "
              + BadInput.quote(name)
              + ": cannot be written ("
              + e
              + "); expected the name of a file in a folder that you may write to");
    }
  }

  private static OutputStream create(String option, String name, Path part) throws IOException {
    try {
      return Files.newOutputStream(part, StandardOpenOption.CREATE_NEW);
    } catch (FileAlreadyExistsException e) {
      throw new BadInput(
          option
              + ": "
              + BadInput.quote(name)
              + ": is being written already, as "
              + part
              + "; expected a file of its own");
    }
  }

  /** Where to write; closed by {@link #close}, and may be closed before. */
  OutputStream stream() {
    return out;
  }

  @Override
  public void close() throws IOException {
    out.close();
    if (written.equals(target)) {
      return;
    }
    if (out.any) {
      Files.move(written, target, StandardCopyOption.REPLACE_EXISTING);
    } else {
      Files.deleteIfExists(written);
    }
  }

  /** Knows whether anything was written. */
  private static final class Counted extends FilterOutputStream {
    private boolean any;

    Counted(OutputStream file) {
      super(new BufferedOutputStream(file));
    }

    @Override
    public void write(int b) throws IOException {
      any = true;
      out.write(b);
    }

    @Override
    public void write(byte[] bytes, int from, int length) throws IOException {
      any |= length > 0;
      out.write(bytes, from, length);
    }
  }
}
