package org.starl.robot.trace;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceSink;
import org.starl.trace.TraceWriter;

/**
 * Writes a robot's trace to its parent process or into a file. Each event is flushed when {@link
 * #record} returns. It ignores a parent that is gone: the child notices that by the end of its orders.
 * From any thread.
 */
public final class ProcessOutbox implements TraceSink {

  private final RobotId self;
  private final TraceWriter writer;
  private final ReentrantLock lock = new ReentrantLock();

  /** @param out takes the trace */
  public ProcessOutbox(RobotId self, TraceHeader header, OutputStream out) {
    this.self = self;
    writer = new TraceWriter(out, header);
  }

  @Override
  public boolean isOn() {
    return true;
  }

  @Override
  public void record(TraceEvent event) {
    lock.lock();
    try {
      writer.record(event);
      writer.flush();
    } finally {
      lock.unlock();
    }
  }

  /** Records an event of the process, which merged traces leave out. */
  public void report(Clock clock, ProcessWord word, Object... args) {
    List<String> texts = new ArrayList<>();
    for (Object arg : args) {
      texts.add(String.valueOf(arg));
    }
    record(word.event(clock.nowNs(), self, texts));
  }

  /** Ends the trace, complete, at this time. */
  public void end(long timeNs) throws IOException {
    lock.lock();
    try {
      writer.end(timeNs);
      writer.close();
    } finally {
      lock.unlock();
    }
  }
}
