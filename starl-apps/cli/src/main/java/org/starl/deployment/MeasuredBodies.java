package org.starl.deployment;

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
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Left;
import org.starl.trace.TraceEvent.Moved;

/**
 * The bodies of a deployment that no world knows the truth of: their robots' traces have them as they
 * were measured. The truth is within a bound of that, and it is tried in several ways: a smaller body
 * is surely where the true one was, a larger one covers wherever it can have been, and bodies moved to
 * each side are for what looks at their middles.
 */
final class MeasuredBodies {

  /**
   * How the true bodies may have been, in multiples of the bound.
   *
   * @param radius added to the body's radius
   * @param x added to its place
   * @param y added to its place
   */
  record Deviation(double radius, double x, double y) {
    static final Deviation NONE = new Deviation(0, 0, 0);
  }

  // At any angle one of the four is nearer to it by at least the bound.
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

  private final Set<RobotId> known = new TreeSet<>();
  private final Map<RobotId, Double> withinMm = new TreeMap<>();
  private final SortedMap<RobotId, Double> lostMs = new TreeMap<>();

  // Whose program starts again measures a body that is there already.
  private final Map<RobotId, RobotTrace> first = new TreeMap<>();

  MeasuredBodies(List<RobotTrace> traces) {
    for (RobotTrace trace : traces) {
      for (TraceEvent event : trace.events()) {
        if (event instanceof Joined joined && trace.isOfWorld()) {
          known.add(joined.robot());
        } else if (event instanceof Joined joined) {
          first.merge(joined.robot(), trace, (a, b) -> a.dateNs() <= b.dateNs() ? a : b);
        }
        MeasuredBody.withinMm(event)
            .ifPresent(mm -> withinMm.merge(event.robot(), mm, Double::max));
        MeasuredBody.lostMs(event).ifPresent(ms -> lostMs.merge(event.robot(), ms, Double::max));
      }
    }
    withinMm.keySet().removeAll(known);
    lostMs.keySet().removeAll(known);
  }

  /** The longest time in ms for which each robot was not measured that was lost at all. */
  SortedMap<RobotId, Double> lostMs() {
    return Collections.unmodifiableSortedMap(lostMs);
  }

  /** The farthest that a true body may have been from where it was measured, in mm; 0 if none was. */
  double withinMm() {
    return withinMm.values().stream().mapToDouble(Double::doubleValue).max().orElse(0);
  }

  /** What to try besides {@link Deviation#NONE}. */
  List<Deviation> deviations() {
    return withinMm.isEmpty() ? List.of() : DEVIATIONS;
  }

  /** What a trace says, all bodies being off so. */
  List<TraceEvent> of(RobotTrace trace, Deviation deviation) {
    List<TraceEvent> events = new ArrayList<>();
    boolean isThere = false;
    for (TraceEvent event : trace.events()) {
      if (trace.isOfWorld() || !isOfBodies(event)) {
        events.add(event);
      } else if (!known.contains(event.robot())) {
        TraceEvent moved = moved(event, deviation);
        boolean isAgain = isThere || !trace.equals(first.get(event.robot()));
        events.add(
            isAgain && moved instanceof Joined again
                ? new Moved(again.timeNs(), again.robot(), again.pose(), 0, 0)
                : moved);
        isThere = true;
      }
    }
    return events;
  }

  private TraceEvent moved(TraceEvent event, Deviation deviation) {
    double mm = withinMm.getOrDefault(event.robot(), 0.0);
    return switch (event) {
      case Joined joined ->
          new Joined(
              joined.timeNs(),
              joined.robot(),
              aside(joined.pose(), mm, deviation),
              Math.max(LEAST_RADIUS_MM, joined.radiusMm() + mm * deviation.radius()));
      case Moved moved ->
          new Moved(
              moved.timeNs(),
              moved.robot(),
              aside(moved.pose(), mm, deviation),
              moved.linearMmPerS(),
              moved.angularRadPerS());
      default -> event;
    };
  }

  private static Pose aside(Pose pose, double mm, Deviation deviation) {
    return new Pose(
        pose.xMm() + mm * deviation.x(), pose.yMm() + mm * deviation.y(), pose.headingRad());
  }

  private static boolean isOfBodies(TraceEvent event) {
    return event instanceof Moved || event instanceof Joined || event instanceof Left;
  }
}
