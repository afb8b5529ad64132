package org.starl.robot.serial;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.starl.robot.create.StreamLink;

/**
 * Virtual serial ports for Linux and macOS with {@code python3}, which opens the pseudo terminal
 * because Java cannot. Other programs open the link's name as a port; the link reads and writes
 * their bytes. It stays open when these programs close their side; it transfers bytes as fast as they
 * come, whatever baud rate is set, and loses them if no program reads.
 */
public final class PseudoTerminal {

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
          terminal = path = os.ttyname(far)
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
                          pass # no program reads: a serial line loses it too
      except (EOFError, BrokenPipeError):
          # a later terminal may have taken the name
          if name and os.path.islink(name) and os.readlink(name) == terminal:
              os.unlink(name)
      """;

  private PseudoTerminal() {}

  /**
   * Opens a pseudo terminal under {@code name}, a symbolic link that is made, or replaced, for it; the
   * empty name stands for the system's own. When the link's {@code close} returns, the name is gone,
   * unless a later terminal has taken it.
   *
   * @throws IOException if there is no python3, or the link cannot be made
   */
  public static StreamLink open(String name) throws IOException {
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
    String path = new String(line, 0, length, StandardCharsets.UTF_8);
    if (path.startsWith("!")) {
      throw new IOException("no pseudo terminal " + name + ": " + path.substring(1));
    }
    return new StreamLink(
        path, process.getInputStream(), process.getOutputStream(), () -> end(process));
  }

  /** The end of its input, or a write that nobody reads, ends the process, which removes the name. */
  private static void end(Process process) throws IOException {
    process.getOutputStream().close();
    process.getInputStream().close();
    try {
      process.waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // it ends by itself, later
    }
  }
}
