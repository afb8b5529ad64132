package org.starl.robot.trace;

import java.util.function.Consumer;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/**
 * A trace whose time 0 is not that of the clock: it begins when its process does.
 *
 * @param startNs what the clock shows at the trace's time 0
 * @param observer is told of each event on the thread that makes it, with the clock's time
 */
public record LateTrace(Outbox trace, long startNs, Consumer<TraceEvent> observer)
    implements TraceSink {

  @Override
  public boolean isOn() {
    return true;
  }

  @Override
  public void record(TraceEvent event) {
    trace.record(event.at(Math.max(0, event.timeNs() - startNs)));
    observer.accept(event);
  }
}
