package org.starl.sim.replay;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;

/**
 * Reads a trace on its own thread into a {@link Recording} for a viewer, all events at once, which
 * is fast. The same thread then checks the specifications, which is slow, and marks violations; the
 * viewer waits for neither. All methods may be called from any thread.
 */
public final class TraceReading implements AutoCloseable {

  private final Recording recording;
  private final Consumer<List<SimObserver>> trace;
  private final Supplier<List<Monitor>> monitors;
  private final Thread thread;
  private volatile boolean isClosed;
  private volatile @Nullable RuntimeException failure;

  /**
   * Reading begins with {@link #start}.
   *
   * @param recording to fill; it must have no other source
   * @param trace passes the whole trace to observers, once; may throw {@link BadInput}, in which
   *     case the earlier events are kept and checked
   * @param monitors creates new monitors of the specifications to check
   */
  public TraceReading(
      Recording recording, Consumer<List<SimObserver>> trace, Supplier<List<Monitor>> monitors) {
    this.recording = recording;
    this.trace = trace;
    this.monitors = monitors;
    thread = new Thread(this::run, "trace");
    thread.setDaemon(true);
    recording.toBeChecked();
  }

  /** Begins to read, once. */
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

  /** Waits until all is read and checked. */
  void await() throws InterruptedException {
    thread.join();
  }

  /**
   * Stops reading and checking, and waits for the end of the thread. An interrupt of the calling
   * thread ends the wait and remains set.
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
      // The reading was closed; the recording keeps its events.
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
    Monitors checks = new Monitors(monitors.get());
    int size = recording.size();
    for (int index = 0; index < size; index++) {
      stopIfClosed();
      int at = index;
      checks.observe(recording.event(index));
      checks.newViolations().forEach(violation -> recording.violated(at, violation));
      recording.checked(index + 1);
    }
    if (failure == null) {
      // Pending deadlines of a truncated run cannot be judged.
      checks.finish(recording.endNs());
      checks.newViolations().forEach(recording::violated);
    }
    recording.allChecked();
  }

  private void stopIfClosed() {
    if (isClosed) {
      throw new CancellationException("nobody watches any more");
    }
  }
}
