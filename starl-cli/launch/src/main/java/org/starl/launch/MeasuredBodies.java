package org.starl.launch;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.robot.MeasuredBody;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceEvent.Variable;

/**
 * The real bodies of a deployment: the robots' traces have their measured positions, and the true
 * positions are within a bound of these. Several cases are tried: a smaller body is certainly inside
 * the true one, a larger one covers it, and bodies moved to each side are for monitors that use
 * centres.
 */
final class MeasuredBodies {

  /**
   * A case of true bodies, in multiples of the bound.
   *
   * @param radius added to the body's radius
   * @param x added to its x
   * @param y added to its y
   */
  record Deviation(double radius, double x, double y) {
    static final Deviation NONE = new Deviation(0, 0, 0);
  }

  // For any direction, one of the four sides is off by at least the bound in it.
  private static final double SIDE = StrictMath.sqrt(2);

  private static final List<Deviation> DEVIATIONS =
      List.of(
          new Deviation(-1, 0, 0),
          new Deviation(1, 0, 0),
          new Deviation(0, SIDE, 0),
          new Deviation(0, -SIDE, 0),
          new Deviation(0, 0, SIDE),
          new Deviation(0, 0, -SIDE));

  private static final double LEAST_RADIUS_MM = 1;

  private final Set<RobotId> simulated = new TreeSet<>();
  private final Map<RobotId, Double> withinMm = new TreeMap<>();
  private final SortedMap<RobotId, Double> lostMs = new TreeMap<>();

  // The first trace of each body: a restarted program measures a body that is on the floor already.
  private final Map<RobotId, RecordedTrace> first = new TreeMap<>();

  MeasuredBodies(List<RecordedTrace> traces) {
    for (RecordedTrace trace : traces) {
      for (TraceEvent event : trace.events()) {
        if (event instanceof Joined joined && trace.hasTrueBodies()) {
          simulated.add(joined.robot());
        } else if (event instanceof Joined joined) {
          first.merge(joined.robot(), trace, (a, b) -> a.dateNs() <= b.dateNs() ? a : b);
        }
        if (event instanceof Action action) {
          switch (action.fact()) {
            case MeasuredBody.Within within ->
                withinMm.merge(event.robot(), (double) within.mm(), Double::max);
            case MeasuredBody.Lost lost ->
                lostMs.merge(event.robot(), (double) lost.ms(), Double::max);
            default -> {}
          }
        }
      }
    }
    withinMm.keySet().removeAll(simulated);
    lostMs.keySet().removeAll(simulated);
  }

  /** For each robot with a gap in its measurements, the longest gap in ms. */
  SortedMap<RobotId, Double> lostMs() {
    return Collections.unmodifiableSortedMap(lostMs);
  }

  /** The largest distance in mm of a true body from its measured place; 0 if none was measured. */
  double withinMm() {
    return withinMm.values().stream().mapToDouble(Double::doubleValue).max().orElse(0);
  }

  /** The cases to try besides {@link Deviation#NONE}. */
  List<Deviation> deviations() {
    return withinMm.isEmpty() ? List.of() : DEVIATIONS;
  }

  /**
   * The events of a trace, with its measured bodies in this case. Where a world's trace has the true
   * body, a measured pose is what the robot believed: a {@link org.starl.motion.Deviation} from the
   * origin.
   */
  List<TraceEvent> events(RecordedTrace trace, Deviation deviation) {
    List<TraceEvent> events = new ArrayList<>();
    boolean isOnFloor = false;
    for (TraceEvent event : trace.events()) {
      if (trace.hasTrueBodies() || !isOfBody(event)) {
        events.add(event);
      } else if (!simulated.contains(event.robot())) {
        TraceEvent deviated = deviated(event, deviation);
        RecordedTrace start = first.get(event.robot());
        boolean isAgain = isOnFloor || start == null || !start.name().equals(trace.name());
        events.add(
            isAgain && deviated instanceof Joined again
                ? new Moved(again.timeNs(), again.robot(), again.pose(), 0, 0)
                : deviated);
        isOnFloor = true;
      } else if (event instanceof Moved moved) {
        events.add(believed(moved, moved.pose()));
      } else if (event instanceof Joined joined) {
        events.add(believed(joined, joined.pose()));
      }
    }
    return events;
  }

  private static Variable believed(TraceEvent event, Pose pose) {
    var fromOrigin =
        new org.starl.motion.Deviation(pose.xMm(), pose.yMm(), pose.headingRad(), 0, StrictMath.PI);
    return new Variable(
        event.timeNs(),
        event.robot(),
        org.starl.motion.Deviation.SOURCE,
        org.starl.motion.Deviation.VAR,
        fromOrigin);
  }

  private TraceEvent deviated(TraceEvent event, Deviation deviation) {
    double mm = withinMm.getOrDefault(event.robot(), 0.0);
    return switch (event) {
      case Joined joined ->
          new Joined(
              joined.timeNs(),
              joined.robot(),
              deviated(joined.pose(), mm, deviation),
              Math.max(LEAST_RADIUS_MM, joined.radiusMm() + mm * deviation.radius()));
      case Moved moved ->
          new Moved(
              moved.timeNs(),
              moved.robot(),
              deviated(moved.pose(), mm, deviation),
              moved.linearMmPerS(),
              moved.angularRadPerS());
      default -> event;
    };
  }

  private static Pose deviated(Pose pose, double mm, Deviation deviation) {
    return new Pose(
        pose.xMm() + mm * deviation.x(), pose.yMm() + mm * deviation.y(), pose.headingRad());
  }

  private static boolean isOfBody(TraceEvent event) {
    return event instanceof Moved || event instanceof Joined || event instanceof Left;
  }
}
