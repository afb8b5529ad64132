package org.starl.robot.trace;

import java.io.IOException;
import java.io.OutputStream;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceSink;
import org.starl.trace.TraceWriter;

/**
 * Writes a robot's trace to its parent process or into a file. Each event is flushed when {@link
 * #record} returns. From any thread.
 */
public final class ProcessTrace implements TraceSink {

  private final RobotId self;
  private final TraceWriter writer;
  private final Consumer<IOException> onFailure;
  private boolean hasFailed;

  /**
   * Ignores a parent that is gone: the child notices that at the end of its input.
   *
   * @param out takes the trace
   */
  public ProcessTrace(RobotId self, TraceHeader header, OutputStream out) {
    this(self, header, out, failure -> {});
  }

  /**
   * The same with a receiver of failures.
   *
   * @param onFailure called once, on the thread that records, when the trace cannot be written;
   *     nothing more is written then
   */
  public ProcessTrace(
      RobotId self, TraceHeader header, OutputStream out, Consumer<IOException> onFailure) {
    this.self = self;
    this.onFailure = onFailure;
    writer = new TraceWriter(out, header);
  }

  @Override
  public boolean isOn() {
    return true;
  }

  @Override
  public void record(TraceEvent event) {
    IOException failure = write(event);
    if (failure != null) {
      onFailure.accept(new IOException("the trace cannot be written: " + failure.getMessage()));
    }
  }

  /** The failure, if this event is the first one that cannot be written. */
  private synchronized @Nullable IOException write(TraceEvent event) {
    writer.record(event);
    writer.flush();
    IOException failure = hasFailed ? null : writer.failure();
    hasFailed |= failure != null;
    return failure;
  }

  /** Records an event of the process, which merged traces leave out. */
  public void report(Clock clock, ProcessFact fact) {
    record(Action.of(clock.nowNs(), self, ProcessFact.SOURCE, ProcessFact.SHAPE, fact));
  }

  /** Ends the trace, complete, at this time. */
  public synchronized void end(long timeNs) throws IOException {
    writer.end(timeNs);
    writer.close();
  }
}
