package org.starl.cli.command;

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
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.FailureText;

/**
 * A file that is written completely or not at all: the output goes to a temporary file beside it,
 * which is renamed on close. Without output, nothing changes. A device (a terminal, a pipe) is
 * written directly.
 */
public final class OutputFile implements Closeable {

  /** The endings of the options' files. */
  private static final Map<String, String> ENDINGS =
      Map.ofEntries(
          Map.entry("--chart", "svg"),
          Map.entry("--csv", "csv"),
          Map.entry("--csv-messages", "csv"),
          Map.entry("--csv-variables", "csv"),
          Map.entry("--png", "png"),
          Map.entry("--pvs", "pvs"),
          Map.entry("--report", "html"),
          Map.entry("--trace", "trace"));

  /** Endings that promise a kind of file. Any other promises nothing. */
  private static final Set<String> KINDS =
      Set.of("csv", "gif", "html", "jpg", "json", "mcap", "mp4", "pdf", "png", "pvs", "svg");

  private final Path target;
  private final Path written;
  private final RecordingStream out;

  /**
   * @param option the option's name, for errors: {@code --trace}
   * @throws BadInput if the file cannot be written, or its name promises another kind of file
   */
  public OutputFile(String option, String name) {
    String ending = ENDINGS.get(option);
    if (ending != null) {
      requireEnding(option, name, ending);
    }
    try {
      Path path = Path.of(name).toAbsolutePath();
      boolean isDevice =
          Files.exists(path) && !Files.isRegularFile(path) && !Files.isDirectory(path);
      target = Files.isRegularFile(path) ? path.toRealPath() : path;
      Path folder = target.getParent();
      if (name.isEmpty() || folder == null || Files.isDirectory(target)) {
        throw bad(option, name, "expected a file's name");
      }
      if (isDevice) {
        written = target;
        out =
            new RecordingStream(
                option + ": " + BadInput.quote(name),
                Files.newOutputStream(target, StandardOpenOption.WRITE));
        return;
      }
      createFolder(folder);
      long process = ProcessHandle.current().pid();
      written = folder.resolve("." + target.getFileName() + "." + process + ".part");
      out =
          new RecordingStream(option + ": " + BadInput.quote(name), create(option, name, written));
      // If the user stops the run, close is not called.
      written.toFile().deleteOnExit();
    } catch (IOException | InvalidPathException e) {
      throw unwritable(option, name, e);
    }
  }

  /** With the folders around it; those that are empty when this process ends are deleted. */
  public static void createFolder(Path folder) throws IOException {
    Path outer = folder.getParent();
    if (!Files.isDirectory(folder) && outer != null) {
      createFolder(outer);
      Files.createDirectories(folder);
      folder.toFile().deleteOnExit();
    }
  }

  /**
   * Checks that the name of a file does not promise another kind than it will have.
   *
   * @throws BadInput with the name and the ending
   */
  public static void requireEnding(String option, String name, String ending) {
    String last = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    if (KINDS.contains(last) && !last.equals(ending)) {
      throw bad(option, name, "expected a name that ends with ." + ending);
    }
  }

  /** The error of a file that cannot be created. */
  public static BadInput unwritable(String option, String name, Exception cause) {
    return bad(
        option,
        name,
        "cannot be written ("
            + FailureText.of(cause)
            + "); expected the name of a file in a writable folder");
  }

  private static OutputStream create(String option, String name, Path part) throws IOException {
    try {
      return Files.newOutputStream(part, StandardOpenOption.CREATE_NEW);
    } catch (FileAlreadyExistsException e) {
      throw bad(
          option,
          name,
          "another output writes this file already (%s); expected a file of its own"
              .formatted(part));
    }
  }

  private static BadInput bad(String option, String name, String text) {
    return new BadInput(option + ": " + BadInput.quote(name) + ": " + text);
  }

  /** Whether the file has any content. */
  public boolean isWritten() {
    return out.any;
  }

  /** The stream to write to. {@link #close} closes it; it may be closed before. */
  public OutputStream stream() {
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

  /**
   * Records whether anything was written. An error names the file and is thrown by {@link #close},
   * not where the output is made: what makes it, such as a run, has not failed.
   */
  private static final class RecordingStream extends FilterOutputStream {
    private final String name;
    private boolean any;
    private @Nullable IOException failure;

    RecordingStream(String name, OutputStream file) {
      super(new BufferedOutputStream(file));
      this.name = name;
    }

    @Override
    public void write(int b) {
      write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int from, int length) {
      any |= length > 0;
      unlessFailed(() -> out.write(bytes, from, length));
    }

    @Override
    public void flush() {
      unlessFailed(out::flush);
    }

    @Override
    public void close() throws IOException {
      unlessFailed(out::close);
      if (failure != null) {
        // Another object each time: the stream is closed by its writer and by the file.
        throw new IOException(
            name + ": cannot be written (" + FailureText.of(failure) + ")", failure);
      }
    }

    private void unlessFailed(Output output) {
      if (failure == null) {
        try {
          output.run();
        } catch (IOException e) {
          failure = e;
        }
      }
    }
  }

  @FunctionalInterface
  private interface Output {
    void run() throws IOException;
  }
}
