package org.starl.robot.serial;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import org.starl.robot.create.ByteLink;

/**
 * The far side of a virtual serial port: other programs open {@link #path} as a port, and this side
 * reads and writes their bytes. For Linux and macOS with {@code python3}, which opens the pseudo
 * terminal because Java cannot. It outlives programs that open and close it; it transfers bytes as
 * fast as they come, whatever baud rate is set, and loses them if no program reads.
 */
public final class PseudoTerminal implements ByteLink {

  private static final int LONGEST_PATH = 4096;

  /** Opens a pseudo terminal, names it, and passes bytes between it and standard input, output. */
  private static final String SCRIPT =
      """
      import os, pty, select, sys, tty
      name = sys.argv[1]
      try:
          near, far = pty.openpty()
          tty.setraw(far)
          os.set_blocking(near, False)
          path = os.ttyname(far)
          if name:
              if os.path.islink(name):
                  os.unlink(name)
              os.symlink(path, name)
              path = name
      except OSError as error:
          os.write(1, b'!' + error.strerror.encode() + b'\\n')
          sys.exit(1)
      os.write(1, path.encode() + b'\\n')
      try:
          while True:
              for ready in select.select([0, near], [], [])[0]:
                  data = os.read(ready, 4096)
                  if not data:
                      raise EOFError
                  if ready == near:
                      while data:
                          data = data[os.write(1, data):]
                  else:
                      try:
                          os.write(near, data)
                      except BlockingIOError:
                          pass # nobody reads: a serial line loses it too
      except (EOFError, BrokenPipeError):
          if name and os.path.islink(name):
              os.unlink(name)
      """;

  private final Process process;
  private final String path;

  private PseudoTerminal(Process process, String path) {
    this.process = process;
    this.path = path;
  }

  /** A pseudo terminal with the system's name. */
  public static PseudoTerminal open() throws IOException {
    return open("");
  }

  /**
   * A pseudo terminal under {@code name}, a symbolic link that is made, or replaced, for it.
   *
   * @throws IOException if there is no python3, or the link cannot be made
   */
  public static PseudoTerminal open(String name) throws IOException {
    String absolute = name.isEmpty() ? "" : new File(name).getAbsolutePath();
    Process process = new ProcessBuilder("python3", "-c", SCRIPT, absolute).start();
    byte[] line = new byte[LONGEST_PATH];
    int length = 0;
    for (int b = process.getInputStream().read(); b != '\n'; b = process.getInputStream().read()) {
      if (b < 0 || length == line.length) {
        process.destroy();
        throw new IOException("no pseudo terminal " + name);
      }
      line[length++] = (byte) b;
    }
    String said = new String(line, 0, length, StandardCharsets.UTF_8);
    if (said.startsWith("!")) {
      throw new IOException("no pseudo terminal " + name + ": " + said.substring(1));
    }
    return new PseudoTerminal(process, said);
  }

  /** The path that the other side opens. */
  public String path() {
    return path;
  }

  @Override
  public InputStream input() {
    return process.getInputStream();
  }

  @Override
  public OutputStream output() {
    return process.getOutputStream();
  }

  /** Removes the pseudo terminal and its name. */
  @Override
  public void close() throws IOException {
    // The end of its input ends the process, which removes the name.
    process.getOutputStream().close();
  }

  @Override
  public String toString() {
    return path;
  }
}
