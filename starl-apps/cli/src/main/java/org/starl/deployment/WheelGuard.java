package org.starl.deployment;

import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.starl.robot.create.ByteLink;
import org.starl.robot.file.Wheels.Port;

/**
 * A process between a robot's program and its wheels. A Create has no watchdog of its own: when the
 * process of its driver is killed, or frozen, it goes on with its last command. The guard has the
 * Create's port, passes bytes both ways between that and its standard input and output, stops the wheels
 * when its input is silent, which no driver is, and makes the Create stand when its input ends, for
 * whatever reason. A guard that is itself killed leaves the wheels to the driver's next guard.
 */
public final class WheelGuard {

  /** Both wheels 0 mm/s, then passive. What was cut off before it may swallow the first. */
  private static final byte[] STAND = {(byte) 145, 0, 0, 0, 0, (byte) 128};

  /** The first of it. */
  private static final int STOP_BYTES = 5;

  private static final int STANDS = 3;

  /** A driver that lives says something every 50 ms, and every 100 ms while it starts the robot. */
  private static final long SILENCE_MS = 300;

  /** A port that is closed forgets what it has not sent: at 300 baud these bytes take 600 ms. */
  private static final long DRAIN_MS = 700;

  private static final int BUFFER_BYTES = 256;
  private static final long CLOSE_MS = 2000;
  private static final List<String> JAVA_OPTIONS =
      List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-Xmx32m");

  private final ByteLink link;
  private final ReentrantLock lock = new ReentrantLock();
  private final Thread voice = daemon("voice", this::listen);
  private final Thread watch = daemon("watch", this::watch);

  // Guarded by the lock.
  private final Condition spoken = lock.newCondition();
  private boolean mayTurn;
  private boolean hasStood;

  private WheelGuard(ByteLink link) {
    this.link = link;
  }

  private static Thread daemon(String name, Runnable body) {
    Thread thread = new Thread(body, name);
    thread.setDaemon(true);
    return thread;
  }

  /** Links to a Create with a guard between, another one for each link. */
  static ByteLink.Source source(Port port, int baud) {
    return () -> {
      List<String> command = new ArrayList<>();
      command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
      command.addAll(JAVA_OPTIONS);
      command.add("--enable-native-access=ALL-UNNAMED");
      command.addAll(List.of("-cp", System.getProperty("java.class.path")));
      command.addAll(List.of(WheelGuard.class.getName(), port.toString(), Integer.toString(baud)));
      return new Guarded(port, new ProcessBuilder(command).start());
    };
  }

  /**
   * Runs a guard; where there is no link, its exit status is 1 and its last line says why.
   *
   * @param args port and baud
   */
  public static void main(String[] args) {
    int status = 0;
    try (ByteLink link = ByteLinks.direct(args[0], Integer.parseInt(args[1])).open()) {
      WheelGuard guard = new WheelGuard(link);
      Runtime.getRuntime().addShutdownHook(new Thread(guard::stand, "guard's end"));
      guard.voice.start();
      guard.watch.start();
      guard.pass();
    } catch (IOException e) {
      sayAtLast(String.valueOf(e.getMessage()));
      status = 1;
    }
    Runtime.getRuntime().exit(status);
  }

  /** Passes what the program says on to the Create until there is no program. */
  private void pass() throws IOException {
    try (InputStream in = new FileInputStream(FileDescriptor.in)) {
      byte[] buffer = new byte[BUFFER_BYTES];
      for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
        write(buffer, n);
      }
    } finally {
      stand();
    }
  }

  /** Passes what the Create says on to the program. */
  private void listen() {
    try (OutputStream out = new FileOutputStream(FileDescriptor.out)) {
      byte[] buffer = new byte[BUFFER_BYTES];
      InputStream from = link.input();
      for (int n = from.read(buffer); n >= 0; n = from.read(buffer)) {
        out.write(buffer, 0, n);
      }
      sayAtLast(link + " was closed");
      Runtime.getRuntime().exit(1);
    } catch (IOException e) {
      // No program or no Create: either way there is nothing left to pass on.
      sayAtLast(link + ": " + e.getMessage());
      Runtime.getRuntime().exit(1);
    }
  }

  /** To the program, as the reason for which its link has ended. */
  private static void sayAtLast(String line) {
    try (OutputStream err = new FileOutputStream(FileDescriptor.err)) {
      err.write(line.getBytes(Charset.defaultCharset()));
    } catch (IOException e) {
      // The program is gone: nobody asks for a reason.
      return;
    }
  }

  private void write(byte[] bytes, int length) throws IOException {
    lock.lock();
    try {
      if (!hasStood) {
        link.output().write(bytes, 0, length);
        link.output().flush();
        mayTurn = true;
        spoken.signal();
      }
    } finally {
      lock.unlock();
    }
  }

  /** Stops the wheels of a program that is silent; what it says after that is passed on again. */
  private void watch() {
    lock.lock();
    try {
      while (!hasStood) {
        if (!spoken.await(SILENCE_MS, TimeUnit.MILLISECONDS) && mayTurn) {
          link.output().write(STAND, 0, STOP_BYTES);
          link.output().flush();
          mayTurn = false;
        }
      }
    } catch (InterruptedException e) {
      // Nobody but a stranger interrupts this thread, and means that it shall end.
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      // No Create: there is nothing left to watch over.
      Runtime.getRuntime().exit(1);
    } finally {
      lock.unlock();
    }
  }

  private void stand() {
    try {
      // Who has the lock for longer waits for a line that takes no more: nothing can be said over
      // it.
      if (lock.tryLock(DRAIN_MS, TimeUnit.MILLISECONDS)) {
        try {
          standAtLast();
        } finally {
          lock.unlock();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void standAtLast() throws InterruptedException {
    try {
      for (int i = 0; i < STANDS && !hasStood; i++) {
        link.output().write(STAND);
        link.output().flush();
      }
      if (!hasStood) {
        hasStood = true;
        mayTurn = false;
        // The port stays open for as long as the Create may still be told.
        voice.join(DRAIN_MS);
      }
    } catch (IOException e) {
      // There is no link left to say it over.
      hasStood = true;
    }
  }

  /** The program's end. */
  private static final class Guarded implements ByteLink {
    private final Port port;
    private final Process process;
    private final InputStream input;

    Guarded(Port port, Process process) {
      this.port = port;
      this.process = process;
      input = new Heard(port, process);
    }

    @Override
    public InputStream input() {
      return input;
    }

    @Override
    public OutputStream output() {
      return process.getOutputStream();
    }

    /** The end of its input ends the guard; one that is frozen, or stuck in a write, is killed. */
    @Override
    public void close() throws IOException {
      try {
        process.getOutputStream().close();
        if (!process.waitFor(CLOSE_MS, TimeUnit.MILLISECONDS)) {
          process.destroyForcibly();
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public String toString() {
      return port.toString();
    }
  }

  /** What the Create says; at the end, what the guard has said of that. */
  private static final class Heard extends FilterInputStream {
    private final Port port;
    private final Process process;

    Heard(Port port, Process process) {
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
        throw new IOException(port + ": its guard was given up", e);
      }
      return count < 0 ? end() : count;
    }

    private int end() throws IOException {
      byte[] words = process.getErrorStream().readAllBytes();
      String last =
          new String(words, Charset.defaultCharset())
              .strip()
              .lines()
              .reduce("", (before, line) -> line);
      throw new IOException(last.isEmpty() ? port + ": its guard has ended" : last);
    }
  }
}
