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
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.SocketLink;
import org.starl.robot.create.StreamLink;
import org.starl.robot.file.Limits;
import org.starl.robot.file.Wheels.Port;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.serial.SerialLink;
import org.starl.time.Time;

/**
 * A process between a robot's program and its Create. A Create has no watchdog: when the driver's
 * process is killed or frozen, the Create continues its last command. The guard has the Create's port
 * and passes bytes between the port and its standard input and output. It stops the wheels when its
 * input ends, for any reason, and when the time of the driver's last command is too long ago: a live
 * driver repeats it. So a command that was held up on its way is not executed late: older wheel
 * speeds are dropped, and the wheels stop instead.
 *
 * <p>A guard that is killed, or that passes nothing for {@link #SILENT_MS}, is replaced by another one.
 * Before that the driver's own process stops the wheels, because a JVM takes long to start.
 */
public final class WheelGuard {

  /** Both wheels 0 mm/s, then passive mode. Sent repeatedly: a truncated command may swallow one. */
  private static final byte[] HALT = {(byte) 145, 0, 0, 0, 0, (byte) 128};

  /** The length of the stop command in {@link #HALT}. */
  private static final int STOP_BYTES = 5;

  private static final int HALT_COPIES = 3;

  /** A Create streams every 15 ms; after this time without frames the driver replaces its guard. */
  public static final long SILENT_MS = 500;

  /** A live driver writes every 50 ms, and every 100 ms while it starts the robot. */
  private static final long MIN_VALID_MS = 150;

  private static final long MAX_VALID_MS = 300;

  /** Closing a port drops its unsent bytes; at 300 baud these take 600 ms. */
  private static final long DRAIN_MS = 700;

  private static final int BUFFER_BYTES = 256;

  /** A guard that has not ended by then is frozen or stuck in a write. */
  private static final long CLOSE_MS = 200;

  private static final int HEAP_MB = 32;
  private static final int LINK_FAILED = 1;
  private static final String TCP = "tcp:";

  private final ByteLink link;
  private final long validNs;
  private final ReentrantLock lock = new ReentrantLock();
  private final Thread reader = Daemons.of("reader", this::passToProgram);
  private final Thread watchdog = Daemons.of("watchdog", this::watch);

  // Guarded by the lock.
  private final Condition written = lock.newCondition();
  private boolean wheelsMayTurn;
  private boolean isHalted;
  private long lastSentNs = Long.MIN_VALUE;

  private WheelGuard(ByteLink link, long validMs) {
    this.link = link;
    validNs = validMs * Time.NS_PER_MS;
  }

  /** For how long a guard executes a command: the reaction time, from 150 to 300 ms. */
  static long validMs(Limits limits) {
    return Math.min(MAX_VALID_MS, Math.max(MIN_VALID_MS, limits.reactionMs()));
  }

  /** Links to a Create through a guard; each link has a guard of its own. */
  public static ByteLink.Source links(Port port, int baud, Limits limits) {
    String address = port.toString();
    List<String> args = List.of(address, Integer.toString(baud), Long.toString(validMs(limits)));
    List<String> command = JavaProcess.command(HEAP_MB, WheelGuard.class.getName(), args);
    return () -> {
      Process process = new ProcessBuilder(command).start();
      return new StreamLink(
          address,
          new GuardedInput(port, process),
          new GuardedOutput(process.getOutputStream()),
          new GuardEnd(process, direct(address, baud)));
    };
  }

  private static ByteLink.Source direct(String port, int baud) {
    if (!port.startsWith(TCP)) {
      return SerialLink.at(port, baud);
    }
    int colon = port.lastIndexOf(':');
    String host = port.substring(TCP.length(), colon).replace("[", "").replace("]", "");
    return SocketLink.to(host, Integer.parseInt(port.substring(colon + 1)));
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
    try (ByteLink link = direct(args[0], Integer.parseInt(args[1])).open()) {
      WheelGuard guard = new WheelGuard(link, Long.parseLong(args[2]));
      Runtime.getRuntime().addShutdownHook(new Thread(guard::halt, "guard's end"));
      guard.reader.start();
      guard.watchdog.start();
      guard.passToCreate();
    } catch (IOException e) {
      reportReason(String.valueOf(e.getMessage()));
      status = LINK_FAILED;
    }
    Runtime.getRuntime().exit(status);
  }

  /** Passes bytes from the program to the Create until the program ends. */
  private void passToCreate() throws IOException {
    try (DataInputStream in =
        new DataInputStream(new BufferedInputStream(new FileInputStream(FileDescriptor.in)))) {
      while (true) {
        pass(GuardedOutput.Write.read(in));
      }
    } catch (EOFException end) {
      return; // the program has ended
    } finally {
      halt();
    }
  }

  /** Passes bytes from the Create to the program. */
  private void passToProgram() {
    try (OutputStream out = new FileOutputStream(FileDescriptor.out)) {
      byte[] buffer = new byte[BUFFER_BYTES];
      InputStream from = link.input();
      for (int n = from.read(buffer); n >= 0; n = from.read(buffer)) {
        out.write(buffer, 0, n);
      }
      reportReason(link + " was closed");
      Runtime.getRuntime().exit(LINK_FAILED);
    } catch (IOException e) {
      // The program or the Create is gone.
      reportReason(link + ": " + e.getMessage());
      Runtime.getRuntime().exit(LINK_FAILED);
    }
  }

  /** Reports to the program why its link has ended. */
  private static void reportReason(String line) {
    try (OutputStream err = new FileOutputStream(FileDescriptor.err)) {
      err.write(line.getBytes(Charset.defaultCharset()));
    } catch (IOException e) {
      return; // the program is gone
    }
  }

  private void pass(GuardedOutput.Write write) throws IOException {
    lock.lock();
    try {
      boolean isValid = RealClock.machineNs() - write.sentNs < validNs;
      if (isHalted) {
        return;
      }
      if (!isValid && isSpeeds(write.bytes)) {
        stop();
        return;
      }
      link.output().write(write.bytes);
      link.output().flush();
      if (isValid) {
        lastSentNs = Math.max(lastSentNs, write.sentNs);
        wheelsMayTurn = true;
        written.signal();
      }
    } finally {
      lock.unlock();
    }
  }

  private static boolean isSpeeds(byte[] bytes) {
    return bytes.length == STOP_BYTES && bytes[0] == HALT[0];
  }

  /** Stops the wheels of a silent program; its later bytes are passed on again. */
  private void watch() {
    lock.lock();
    try {
      while (!isHalted) {
        long leftNs = lastSentNs + validNs - RealClock.machineNs();
        if (!wheelsMayTurn) {
          written.await();
        } else if (leftNs > 0) {
          written.awaitNanos(leftNs);
        } else {
          stop();
        }
      }
    } catch (InterruptedException e) {
      // StarL never interrupts this thread: an interrupt is a request to end it.
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      // The Create is gone.
      Runtime.getRuntime().exit(LINK_FAILED);
    } finally {
      lock.unlock();
    }
  }

  // With the lock held.
  private void stop() throws IOException {
    if (wheelsMayTurn) {
      link.output().write(HALT, 0, STOP_BYTES);
      link.output().flush();
      wheelsMayTurn = false;
    }
  }

  private void halt() {
    try {
      // A thread that holds the lock longer waits for a stuck line: stopping is impossible.
      if (lock.tryLock(DRAIN_MS, TimeUnit.MILLISECONDS)) {
        try {
          haltNow();
        } finally {
          lock.unlock();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void haltNow() throws InterruptedException {
    try {
      for (int i = 0; i < HALT_COPIES && !isHalted; i++) {
        link.output().write(HALT);
        link.output().flush();
      }
      if (!isHalted) {
        isHalted = true;
        wheelsMayTurn = false;
        // Keep the port open until the bytes are sent.
        reader.join(DRAIN_MS);
      }
    } catch (IOException e) {
      // There is no link any more.
      isHalted = true;
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
          stopWheels();
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

    private void stopWheels() throws IOException {
      try (ByteLink link = port.open()) {
        for (int i = 0; i < HALT_COPIES; i++) {
          link.output().write(HALT, 0, STOP_BYTES);
        }
        link.output().flush();
      }
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
