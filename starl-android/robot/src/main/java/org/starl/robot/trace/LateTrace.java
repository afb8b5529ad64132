package org.starl.robot.trace;

import java.util.function.Consumer;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

/**
 * A trace whose time 0 is the start of its process, not the clock's origin.
 *
 * @param startNs the clock's value at the trace's time 0
 * @param observer takes each event, with the clock's time, on the thread that makes the event
 */
public record LateTrace(ProcessTrace trace, long startNs, Consumer<TraceEvent> observer)
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
