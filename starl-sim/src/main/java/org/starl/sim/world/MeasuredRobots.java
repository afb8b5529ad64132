package org.starl.sim.world;

import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.geometry.Fix;
import org.starl.id.RobotId;
import org.starl.platform.Clock;

/** The newest fix of each robot of a run, as its measuring system publishes them to all robots. */
public final class MeasuredRobots {

  // Times are true times.
  private final SortedMap<RobotId, Fix> newest = new TreeMap<>();

  void measured(RobotId robot, Fix fix) {
    newest.put(robot, fix);
  }

  /** A copy, with times on the clock of a robot that reads it now. */
  SortedMap<RobotId, Fix> shownTo(Clock robotClock, Clock trueClock) {
    long aheadNs = robotClock.nowNs() - trueClock.nowNs();
    SortedMap<RobotId, Fix> shown = new TreeMap<>();
    newest.forEach((robot, fix) ->
        shown.put(
            robot, new Fix(fix.pose(), fix.timeNs() + aheadNs, fix.errorMm(), fix.errorRad())));
    return shown;
  }
}
