package org.starl.launch;

import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.motion.Location;
import org.starl.robot.MeasuredBody;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Variable;

/**
 * What robots believe of their poses, in a merged run whose true bodies are known from a world's
 * trace: the poses that they measured, minus the true ones, as a simulator traces them.
 */
final class Beliefs {

  /** A smaller change is not told. */
  private static final double SHOWN_MM = 25;

  private final Bodies truth = new Bodies();
  private final Map<RobotId, Double> withinMm = new TreeMap<>();
  private final Map<RobotId, Deviation> told = new TreeMap<>();

  /** Takes an event of the merged run. */
  void observe(TraceEvent event) {
    truth.observe(event);
    if (event instanceof Action action && action.fact() instanceof MeasuredBody.Within within) {
      withinMm.put(event.robot(), (double) within.mm());
    } else if (event instanceof Fault fault && fault.name().equals(Fault.CRASH)) {
      told.remove(fault.robot());
    }
  }

  /** What a measured pose tells; null if nothing new. */
  @Nullable Variable of(RobotId robot, Pose measured, long timeNs) {
    if (!truth.isOnFloor(robot)) {
      return null;
    }
    double errorMm = withinMm.getOrDefault(robot, 0.0);
    Location.Known belief = new Location.Known(measured, errorMm, StrictMath.PI, timeNs, timeNs);
    Deviation now = Deviation.of(belief, truth.poseAt(robot, timeNs));
    if (!now.differs(told.getOrDefault(robot, Deviation.NONE), SHOWN_MM)) {
      return null;
    }
    told.put(robot, now);
    return new Variable(timeNs, robot, Deviation.SOURCE, Deviation.VAR, now);
  }
}
