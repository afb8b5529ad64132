package org.starl.sim.world;

import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.id.RobotId;
import org.starl.platform.Clock;

/** The newest fix of each robot of a run, as its measuring system publishes them to all robots. */
public final class MeasuredRobots {

  private final SortedMap<RobotId, Newest> newest = new TreeMap<>();

  /** The newest fix of one robot, in true time; null before the first. */
  static final class Newest {
    @Nullable Fix fix;
  }

  /** Of this robot, in all its incarnations. */
  Newest of(RobotId robot) {
    return newest.computeIfAbsent(robot, any -> new Newest());
  }

  /** A copy, with times on the clock of a robot that reads it now. */
  SortedMap<RobotId, Fix> shownTo(Clock robotClock, Clock trueClock) {
    long aheadNs = robotClock.nowNs() - trueClock.nowNs();
    SortedMap<RobotId, Fix> shown = new TreeMap<>();
    newest.forEach((robot, last) -> {
      Fix fix = last.fix;
      if (fix != null) {
        shown.put(
            robot, new Fix(fix.pose(), fix.timeNs() + aheadNs, fix.errorMm(), fix.errorRad()));
      }
    });
    return shown;
  }
}
