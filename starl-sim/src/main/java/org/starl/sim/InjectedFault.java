package org.starl.sim;

import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent.Fault;

/**
 * A fault of a run, as its trace tells it.
 *
 * @param robot the affected robot, also if the fault drew it; {@link Fault#WORLD} for several
 * @param isCrash whether the robot's program crashed
 * @param text in the grammar of {@code --fault}; {@code crash} for a crash that no fault caused
 * @param beganNs in ns from the start of the run
 * @param endedNs when it ended, for a crash with the restart; -1 if it had not ended
 */
public record InjectedFault(
    RobotId robot, boolean isCrash, String text, long beganNs, long endedNs) {

  static final long NOT_ENDED = -1;

  /** Whether it was active at this time, or at most {@code settleNs} before. */
  boolean isRecent(long timeNs, long settleNs) {
    return beganNs <= timeNs && (endedNs == NOT_ENDED || endedNs >= timeNs - settleNs);
  }

  InjectedFault ended(long timeNs) {
    return new InjectedFault(robot, isCrash, text, beganNs, timeNs);
  }

  /** {@code jump(any,600mm,at=2s) of bot1 from 2.000 s}. */
  @Override
  public String toString() {
    String whose = robot.equals(Fault.WORLD) ? "" : " of " + robot;
    String from = " from " + Time.text(beganNs, 3);
    return text + whose + from + (endedNs < 0 ? "" : " to " + Time.text(endedNs, 3));
  }
}
