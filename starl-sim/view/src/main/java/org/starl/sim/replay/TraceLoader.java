package org.starl.sim.replay;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.Diagnosis;
import org.starl.sim.Failure;
import org.starl.sim.RunObservers;
import org.starl.sim.SimObserver;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/**
 * Reads a trace into a {@link Recording} on its own thread, which is fast; the same thread then
 * checks the specifications, which is slow, and marks violations. The window waits for neither. All
 * methods are thread-safe.
 */
public final class TraceLoader implements AutoCloseable {

  private final Recording recording;
  private final Consumer<List<SimObserver>> trace;
  private final Supplier<List<Monitor>> monitors;
  private final Supplier<List<String>> commands;
  private final Thread thread;
  private volatile boolean isClosed;
  private volatile @Nullable RuntimeException failure;

  /**
   * Prepares a reading; {@link #start} starts it.
   *
   * @param recording the recording to fill, used by no other observer
   * @param trace shows the whole trace to observers, once; if it throws {@link BadInput}, the
   *     events before are kept and checked
   * @param monitors makes new monitors of the specifications
   * @param commands for the description of a failure
   */
  public TraceLoader(
      Recording recording,
      Consumer<List<SimObserver>> trace,
      Supplier<List<Monitor>> monitors,
      Supplier<List<String>> commands) {
    this.recording = recording;
    this.trace = trace;
    this.monitors = monitors;
    this.commands = commands;
    thread = new Thread(this::run, "trace");
    thread.setDaemon(true);
    recording.toBeChecked();
  }

  /** Starts to read; to be called once. */
  public void start() {
    thread.start();
  }

  /** The recording that is filled. */
  public Recording recording() {
    return recording;
  }

  /** The error that ended the reading or the checking, or null. */
  public @Nullable RuntimeException failure() {
    return failure;
  }

  boolean isClosed() {
    return isClosed;
  }

  /** Waits until the whole trace is read and checked. */
  void await() throws InterruptedException {
    thread.join();
  }

  /**
   * Stops to read and to check, and waits for the thread; returns early with the interrupt flag set
   * if the calling thread is interrupted.
   */
  @Override
  public void close() {
    isClosed = true;
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void run() {
    try {
      read();
      check();
    } catch (CancellationException e) {
      // Closed: the events so far remain.
      recording.over(recording.endNs());
    } catch (RuntimeException e) {
      failed("The specifications could not be checked: ", e);
    }
  }

  private void read() {
    SimObserver guard =
        new SimObserver() {
          @Override
          public void observed(TraceEvent event) {
            stopIfClosed();
          }
        };
    try {
      trace.accept(List.of(guard, recording));
    } catch (BadInput e) {
      failed("", e);
    }
  }

  private void failed(String what, RuntimeException error) {
    failure = error;
    recording.failed(what + error.getMessage());
  }

  private void check() {
    SimObserver marker =
        new SimObserver() {
          @Override
          public void violated(SpecReport.Violation violation) {
            recording.violated(Math.min(recording.checked(), recording.size() - 1), violation);
          }

          @Override
          public void wentWrong(Failure found) {
            recording.wentWrong(found);
          }
        };
    RunObservers checks =
        new RunObservers(
            new Monitors(monitors.get()), List.of(marker), violation -> Diagnosis.NONE, commands);
    int size = recording.size();
    for (int index = 0; index < size; index++) {
      stopIfClosed();
      checks.record(recording.event(index));
      recording.checked(index + 1);
    }
    if (failure == null) {
      // Liveness cannot be checked on a truncated trace.
      checks.endSpecifications(recording.endNs());
    }
    recording.allChecked();
  }

  private void stopIfClosed() {
    if (isClosed) {
      throw new CancellationException("the trace was closed");
    }
  }
}
