package org.starl.robot.trace;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.TraceSink;
import org.starl.trace.TraceWriter;

/**
 * Writes a robot's trace to its parent process or into a file. Each event is flushed when {@link
 * #record} returns. It ignores a parent that is gone: the child notices that at the end of its input.
 * From any thread.
 */
public final class ProcessTrace implements TraceSink {

  private final RobotId self;
  private final TraceWriter writer;

  /** @param out takes the trace */
  public ProcessTrace(RobotId self, TraceHeader header, OutputStream out) {
    this.self = self;
    writer = new TraceWriter(out, header);
  }

  @Override
  public boolean isOn() {
    return true;
  }

  @Override
  public synchronized void record(TraceEvent event) {
    writer.record(event);
    writer.flush();
  }

  /** Records an event of the process, which merged traces leave out. */
  public void report(Clock clock, ProcessWord word, Object... args) {
    List<String> texts = Arrays.stream(args).map(String::valueOf).collect(Collectors.toList());
    record(word.event(clock.nowNs(), self, texts));
  }

  /** Ends the trace, complete, at this time. */
  public synchronized void end(long timeNs) throws IOException {
    writer.end(timeNs);
    writer.close();
  }
}
