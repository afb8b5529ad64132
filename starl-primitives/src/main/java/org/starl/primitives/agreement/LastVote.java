package org.starl.primitives.agreement;

import org.jspecify.annotations.Nullable;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;

/**
 * For specifications of primitives over a Synod: tells, in a trace, which robot decides. A robot decides in
 * the step in which it hears the last vote that it needs; a robot that is told what was decided hears no
 * vote in that step.
 */
public final class LastVote {

  private @Nullable Delivered heard;

  /** Sees each event of the run. */
  public void observe(TraceEvent event) {
    if (event instanceof Delivered got && got.message() instanceof SynodMessage) {
      heard = got;
    }
  }

  /** Whether the variable's robot has heard a vote for this number, of the variable's primitive, in this step. */
  public boolean decides(TraceEvent.Variable variable, long number) {
    return decides(variable, variable.source(), number);
  }

  /** Whether the event's robot has heard a vote for this number, of this primitive, in this step. */
  public boolean decides(TraceEvent event, Instance source, long number) {
    return heard != null
        && heard.robot().equals(event.robot())
        && heard.channel().owner().equals(source)
        && heard.timeNs() == event.timeNs()
        && heard.message() instanceof Accepted vote
        && vote.number() == number;
  }
}
