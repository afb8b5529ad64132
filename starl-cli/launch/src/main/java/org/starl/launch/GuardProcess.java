package org.starl.launch;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.SocketLink;
import org.starl.robot.create.StreamLink;
import org.starl.robot.create.WheelGuard;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels.Port;
import org.starl.robot.file.Wheels.Tcp;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.serial.SerialLink;

/**
 * The process of a {@link WheelGuard}. It has the Create's port and passes bytes between the port and
 * its standard input and output. It stops the wheels when its input ends, for any reason.
 */
public final class GuardProcess {

  /** A guard that has not ended by then is frozen or stuck in a write. */
  private static final long CLOSE_MS = 200;

  private static final int HEAP_MB = 32;
  private static final int LINK_FAILED = 1;

  private GuardProcess() {}

  /** Links to a Create through a guard; each link has a guard of its own. */
  public static ByteLink.Source links(Port port, int baud, Limits limits) {
    String address = port.toString();
    long validMs = WheelGuard.validMs(limits.reactionMs());
    List<String> args = List.of(address, Integer.toString(baud), Long.toString(validMs));
    List<String> command = JavaProcess.command(HEAP_MB, GuardProcess.class.getName(), args);
    return () -> {
      Process process = new ProcessBuilder(command).start();
      return new StreamLink(
          address,
          new GuardedInput(port, process),
          new GuardedOutput(process.getOutputStream()),
          new GuardEnd(process, direct(address, baud)));
    };
  }

  /** Starts a guard of another kind of drive. */
  public static Process start(String main, List<String> args) throws IOException {
    return new ProcessBuilder(JavaProcess.command(HEAP_MB, main, args))
        .redirectError(ProcessBuilder.Redirect.INHERIT)
        .start();
  }

  private static ByteLink.Source direct(String port, int baud) {
    return Port.parse(port) instanceof Tcp tcp
        ? SocketLink.to(tcp.address().host(), tcp.address().port())
        : SerialLink.at(port, baud);
  }

  /**
   * Runs a guard. If the port cannot be opened or is lost, its exit status is 1 and its last line
   * on standard error is the reason.
   *
   * @param args the port, as {@link Port} writes it, the baud rate, and for how many ms a command is
   *     valid
   */
  public static void main(String[] args) {
    int status = 0;
    try {
      ByteLink link = direct(args[0], Integer.parseInt(args[1])).open();
      WheelGuard guard = WheelGuard.start(link, Long.parseLong(args[2]));
      SerialLink.atShutdown(guard::close);
      Daemons.of("reader", () -> passToProgram(guard)).start();
      passToCreate(guard);
    } catch (IOException e) {
      reportReason(String.valueOf(e.getMessage()));
      status = LINK_FAILED;
    }
    Runtime.getRuntime().exit(status);
  }

  /** Passes bytes from the program to the Create until the program ends. */
  private static void passToCreate(WheelGuard guard) throws IOException {
    try (DataInputStream in =
        new DataInputStream(new BufferedInputStream(new FileInputStream(FileDescriptor.in)))) {
      while (true) {
        GuardedOutput.Write write = GuardedOutput.Write.read(in);
        guard.pass(write.sentNs, write.bytes);
      }
    } catch (EOFException end) {
      return; // the program has ended
    } finally {
      guard.close();
    }
  }

  /** Passes bytes from the Create to the program; ends the process when one of the two is gone. */
  private static void passToProgram(WheelGuard guard) {
    try (OutputStream out = new FileOutputStream(FileDescriptor.out)) {
      reportReason(guard.passToProgram(out));
    } catch (IOException e) {
      reportReason(String.valueOf(e.getMessage()));
    }
    Runtime.getRuntime().exit(LINK_FAILED);
  }

  /** Reports to the program why its link has ended. */
  private static void reportReason(String line) {
    try (OutputStream err = new FileOutputStream(FileDescriptor.err)) {
      err.write(line.getBytes(Charset.defaultCharset()));
    } catch (IOException e) {
      return; // the program is gone
    }
  }

  /** Ends a guard by closing its input; a guard that is frozen or stuck in a write is killed. */
  private static final class GuardEnd implements Closeable {
    private final Process process;
    private final ByteLink.Source port;
    private boolean isOver;

    GuardEnd(Process process, ByteLink.Source port) {
      this.process = process;
      this.port = port;
    }

    // Two threads may close a link: the next guard needs the port, so the second one waits.
    @Override
    public synchronized void close() throws IOException {
      if (!isOver) {
        isOver = true;
        process.getOutputStream().close();
        if (!hasEndedByItself()) {
          WheelGuard.stopWheels(port);
        }
      }
    }

    /** False if it was killed, so that the wheels may still turn. */
    private boolean hasEndedByItself() {
      try {
        if (!process.waitFor(CLOSE_MS, TimeUnit.MILLISECONDS)) {
          process.destroyForcibly().waitFor();
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      return !process.isAlive() && process.exitValue() <= LINK_FAILED;
    }
  }

  /** Bytes from the Create; at the end, the guard's reason as an exception. */
  private static final class GuardedInput extends FilterInputStream {
    private final Port port;
    private final Process process;

    GuardedInput(Port port, Process process) {
      super(process.getInputStream());
      this.port = port;
      this.process = process;
    }

    @Override
    public int read() throws IOException {
      byte[] one = new byte[1];
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] into, int offset, int length) throws IOException {
      int count;
      try {
        count = super.read(into, offset, length);
      } catch (IOException e) {
        throw new IOException(port + ": its guard was closed", e);
      }
      if (count >= 0) {
        return count;
      }
      byte[] reason = process.getErrorStream().readAllBytes();
      String last =
          new String(reason, Charset.defaultCharset())
              .strip()
              .lines()
              .reduce("", (before, line) -> line);
      throw new IOException(last.isEmpty() ? port + ": its guard has ended" : last);
    }
  }
}
