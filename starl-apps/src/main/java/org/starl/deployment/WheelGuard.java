package org.starl.deployment;

import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import org.starl.deploy.create.ByteLink;
import org.starl.deploy.file.Wheels.Port;

/**
 * A process between a robot's program and its wheels. A Create has no watchdog of its own: when the
 * process of its driver is killed, it goes on with its last command. The guard has the Create's port,
 * passes bytes both ways between that and its standard input and output, and makes the Create stand when
 * its input ends, for whatever reason.
 */
public final class WheelGuard {

  /** Both wheels 0 mm/s, then passive. What was cut off before it may swallow the first. */
  private static final byte[] STAND = {(byte) 145, 0, 0, 0, 0, (byte) 128};

  private static final int STANDS = 3;

  /** A port that is closed forgets what it has not sent: at 300 baud these bytes take 600 ms. */
  private static final long DRAIN_MS = 700;

  private static final int BUFFER_BYTES = 256;
  private static final long CLOSE_MS = 2000;
  private static final List<String> JAVA_OPTIONS =
      List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-Xmx32m");

  private final ByteLink link;
  private final ReentrantLock lock = new ReentrantLock();
  private final Thread voice = new Thread(this::listen, "voice");
  private boolean hasStood;

  private WheelGuard(ByteLink link) {
    this.link = link;
    voice.setDaemon(true);
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
      ProcessBuilder builder = new ProcessBuilder(command);
      return new Guarded(port, builder.redirectError(ProcessBuilder.Redirect.DISCARD).start());
    };
  }

  /**
   * Runs a guard; its exit status is 1 if there is no link.
   *
   * @param args port and baud
   */
  public static void main(String[] args) {
    int status = 0;
    try (ByteLink link = ByteLinks.direct(args[0], Integer.parseInt(args[1])).open()) {
      WheelGuard guard = new WheelGuard(link);
      Runtime.getRuntime().addShutdownHook(new Thread(guard::stand, "guard's end"));
      guard.voice.start();
      guard.pass();
    } catch (IOException e) {
      // Who has started it finds its end closed, and starts another.
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
      Runtime.getRuntime().exit(1);
    } catch (IOException e) {
      // No program or no Create: either way there is nothing left to pass on.
      Runtime.getRuntime().exit(1);
    }
  }

  private void write(byte[] bytes, int length) throws IOException {
    lock.lock();
    try {
      if (!hasStood) {
        link.output().write(bytes, 0, length);
        link.output().flush();
      }
    } finally {
      lock.unlock();
    }
  }

  private void stand() {
    lock.lock();
    try {
      for (int i = 0; i < STANDS && !hasStood; i++) {
        link.output().write(STAND);
        link.output().flush();
      }
      if (!hasStood) {
        hasStood = true;
        // The port stays open for as long as the Create may still be told.
        voice.join(DRAIN_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      // There is no link left to say it over.
      hasStood = true;
    } finally {
      lock.unlock();
    }
  }

  /** The program's end. */
  private record Guarded(Port port, Process process) implements ByteLink {

    @Override
    public InputStream input() {
      return process.getInputStream();
    }

    @Override
    public OutputStream output() {
      return process.getOutputStream();
    }

    /** The end of its input ends the guard. */
    @Override
    public void close() throws IOException {
      try {
        process.getOutputStream().close();
        if (!process.waitFor(CLOSE_MS, TimeUnit.MILLISECONDS)) {
          process.destroy();
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        process.destroy();
      }
    }

    @Override
    public String toString() {
      return port.toString();
    }
  }
}
