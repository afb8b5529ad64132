package org.starl.launch;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;
import org.starl.shape.JsonFormatException;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceReader;
import org.starl.trace.Vocabulary;

/** A robot's process, seen by its parent. Two threads read its output and post events and lines. */
final class ChildProcess {

  /** Receives the events of the process on the parent's thread. */
  interface Listener {

    /**
     * An event of its trace.
     *
     * @param seenNs when it was read, on the machine's clock
     */
    void traced(TraceEvent event, long seenNs);

    /** A line on its standard error, or a problem with its pipes. */
    void warned(String line);

    /**
     * The process has ended; nothing follows.
     *
     * @param isComplete whether its trace has an end
     */
    void ended(boolean isComplete, int status);
  }

  private static final long END_LIMIT_S = 10;

  private final Vocabulary vocabulary;
  private final Executor executor;
  private final Listener listener;
  private final Process process;

  /**
   * Starts it.
   *
   * @param vocabulary the shapes of the values in its trace
   * @param executor runs the listener's methods in order
   * @throws IOException if the program does not exist
   */
  ChildProcess(
      String name,
      List<String> command,
      Vocabulary vocabulary,
      Executor executor,
      Listener listener)
      throws IOException {
    this.vocabulary = vocabulary;
    this.executor = executor;
    this.listener = listener;
    process = new ProcessBuilder(command).start();
    Daemons.of(name + " trace", this::readTrace).start();
    Daemons.of(name + " errors", this::readErrors).start();
  }

  long pid() {
    return process.pid();
  }

  /** Sends a command. If the process has ended, the listener gets a warning. */
  void send(ParentCommand command) {
    try {
      OutputStream in = process.getOutputStream();
      in.write((command + "\n").getBytes(StandardCharsets.UTF_8));
      in.flush();
    } catch (IOException e) {
      warn("does not receive: " + command);
    }
  }

  /** Closes its input, so that it ends in order. */
  void end() {
    try {
      process.getOutputStream().close();
    } catch (IOException e) {
      warn("had ended already");
    }
  }

  /** Ends it as {@code kill -9} does. */
  void kill() {
    process.destroyForcibly();
  }

  /** Waits until it has ended, and kills it if it does not end in time; its exit status. */
  int awaitEnd() {
    try {
      if (process.waitFor(END_LIMIT_S, TimeUnit.SECONDS)) {
        return process.exitValue();
      }
      process.destroyForcibly();
      return process.waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return -1;
    }
  }

  private void warn(String line) {
    executor.execute(() -> listener.warned(line));
  }

  private void readTrace() {
    boolean isComplete = false;
    try (TraceReader trace = new TraceReader("trace", process.getInputStream(), vocabulary)) {
      for (TraceEvent event = trace.next(); event != null; event = trace.next()) {
        TraceEvent read = event;
        long seenNs = RealClock.machineNs();
        executor.execute(() -> listener.traced(read, seenNs));
      }
      isComplete = trace.end() != null;
    } catch (JsonFormatException cutOff) {
      isComplete = false; // killed while it wrote a line
    } catch (IOException e) {
      warn(String.valueOf(e));
    }
    boolean hasEnd = isComplete;
    int status = awaitEnd();
    executor.execute(() -> listener.ended(hasEnd, status));
  }

  private void readErrors() {
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(process.getErrorStream(), StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        warn(line);
      }
    } catch (IOException e) {
      warn(String.valueOf(e));
    }
  }
}
