package org.starl.processes;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import org.starl.id.RobotId;
import org.starl.robot.realtime.RealClock;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceFormatException;
import org.starl.trace.TraceReader;

/**
 * A robot's process as its parent has it. Two threads read what it writes; what they find goes to the
 * fleet's one queue.
 */
final class Member {

  /** What a member's threads tell the fleet. */
  sealed interface Signal {
    RobotId robot();
  }

  /**
   * It did, or said, something.
   *
   * @param seenNs when it was read, on the machine's clock
   */
  record Did(RobotId robot, TraceEvent event, long seenNs) implements Signal {}

  /** It wrote a line on its standard error. */
  record Complained(RobotId robot, String line) implements Signal {}

  /**
   * Its trace has ended, and so has the process.
   *
   * @param isWhole whether it said so itself
   */
  record Gone(RobotId robot, boolean isWhole, int status) implements Signal {}

  private final RobotId robot;
  private final BlockingQueue<Signal> signals;
  private final Process process;

  private Member(RobotId robot, BlockingQueue<Signal> signals, Process process) {
    this.robot = robot;
    this.signals = signals;
    this.process = process;
  }

  /** @throws IOException if there is no such program */
  static Member start(RobotId robot, List<String> command, BlockingQueue<Signal> signals)
      throws IOException {
    Member member = new Member(robot, signals, new ProcessBuilder(command).start());
    daemon(robot + " trace", member::readTrace);
    daemon(robot + " errors", member::readErrors);
    return member;
  }

  private static void daemon(String name, Runnable work) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.start();
  }

  long pid() {
    return process.pid();
  }

  /** A process that is gone, or about to be, needs no orders. */
  void tell(Order order) {
    try {
      OutputStream in = process.getOutputStream();
      in.write((order + "\n").getBytes(StandardCharsets.UTF_8));
      in.flush();
    } catch (IOException e) {
      signals.add(new Complained(robot, "does not hear: " + order));
    }
  }

  /** No more orders: it ends by itself. */
  void dismiss() {
    try {
      process.getOutputStream().close();
    } catch (IOException e) {
      signals.add(new Complained(robot, "was gone already"));
    }
  }

  /** As {@code kill -9}. */
  void kill() {
    process.destroyForcibly();
  }

  /** Ends it, and waits until it has ended. */
  void bury() {
    process.destroyForcibly();
    status();
  }

  private void readTrace() {
    boolean isWhole = false;
    try (TraceReader trace = new TraceReader(robot.name(), process.getInputStream())) {
      for (TraceEvent event = trace.next(); event != null; event = trace.next()) {
        signals.add(new Did(robot, event, RealClock.machineNs()));
      }
      isWhole = trace.end() != null;
    } catch (TraceFormatException cutOff) {
      isWhole = false; // killed in the midst of a line
    } catch (IOException e) {
      signals.add(new Complained(robot, String.valueOf(e)));
    }
    signals.add(new Gone(robot, isWhole, status()));
  }

  private int status() {
    try {
      if (process.waitFor(10, TimeUnit.SECONDS)) {
        return process.exitValue();
      }
      process.destroyForcibly();
      return process.waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return -1;
    }
  }

  private void readErrors() {
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        signals.add(new Complained(robot, line));
      }
    } catch (IOException e) {
      signals.add(new Complained(robot, String.valueOf(e)));
    }
  }
}
