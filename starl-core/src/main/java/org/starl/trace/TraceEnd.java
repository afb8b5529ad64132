package org.starl.trace;

import java.util.List;
import org.starl.id.RobotId;

/**
 * The last line of a complete trace.
 *
 * @param timeNs end of the run, in ns from its start
 * @param events number of events in the trace
 * @param unfinished robots whose apps have not ended, but for robots that left or crashed for good
 */
public record TraceEnd(long timeNs, long events, List<RobotId> unfinished) {

  public TraceEnd {
    unfinished = List.copyOf(unfinished);
  }
}
