package org.starl.cli;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.starl.sim.BadInput;

/**
 * A file that appears whole or not at all: what is written goes beside it, under a name of its own,
 * and takes its place when closed.
 */
final class OutputFile implements Closeable {

  private final Path target;
  private final Path beside;
  private final OutputStream out;

  /**
   * @param option for errors: {@code --trace}
   */
  OutputFile(String option, String name) {
    try {
      target = Path.of(name).toAbsolutePath();
      Path folder = target.getParent();
      if (folder == null || Files.isDirectory(target)) {
        throw new BadInput(option + ": " + BadInput.quote(name) + ": expected a file's name");
      }
      Files.createDirectories(folder);
      beside = folder.resolve("." + target.getFileName() + ".part");
      out = new BufferedOutputStream(Files.newOutputStream(beside));
    } catch (IOException | InvalidPathException e) {
      throw new BadInput(option + ": " + BadInput.quote(name) + ": cannot be written (" + e + ")");
    }
  }

  /** Where to write; closed by {@link #close}, and may be closed before. */
  OutputStream stream() {
    return out;
  }

  @Override
  public void close() throws IOException {
    out.close();
    Files.move(beside, target, StandardCopyOption.REPLACE_EXISTING);
  }
}
