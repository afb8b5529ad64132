package org.starl.primitives.paths;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;

/**
 * What to plan, an immutable snapshot. Millimetres; ends are taken to the nearest whole ones.
 *
 * @param bounds the body stays inside
 * @param obstacles stand all the time that the way takes
 * @param taken regions of others to keep out of, as if they were obstacles
 * @param keepOut where the body's centre may not be, as it is: not widened; its border is free
 * @param bodyRadiusMm the body is a disc of this radius, above 0
 * @param clearanceMm the body keeps at least this far from everything, at least 0
 */
public record PlanTask(
    Point start,
    Point goal,
    Rectangle bounds,
    Obstacles obstacles,
    List<Capsule> taken,
    List<Polygon> keepOut,
    double bodyRadiusMm,
    double clearanceMm) {

  /** No coordinate is farther from 0, in mm: sums and products of them stay exact. */
  public static final int MAX_MM = 1 << 27;

  public PlanTask {
    taken = List.copyOf(taken);
    keepOut = List.copyOf(keepOut);
    boolean sizes = bodyRadiusMm > 0 && clearanceMm >= 0 && bodyRadiusMm + clearanceMm <= MAX_MM;
    if (!sizes || !start.isFinite() || !goal.isFinite()) {
      throw new IllegalArgumentException(
          "plan from "
              + start
              + " to "
              + goal
              + ", body "
              + bodyRadiusMm
              + " mm, clearance "
              + clearanceMm
              + " mm: expected numbers, the body above 0");
    }
    if (bounds.xMinMm() < -MAX_MM
        || bounds.yMinMm() < -MAX_MM
        || bounds.xMaxMm() > MAX_MM
        || bounds.yMaxMm() > MAX_MM) {
      throw new IllegalArgumentException("bounds " + bounds + ": expected within 134 km of 0");
    }
  }

  /** With nowhere that only the centre keeps out of. */
  public PlanTask(
      Point start,
      Point goal,
      Rectangle bounds,
      Obstacles obstacles,
      List<Capsule> taken,
      double bodyRadiusMm,
      double clearanceMm) {
    this(start, goal, bounds, obstacles, taken, List.of(), bodyRadiusMm, clearanceMm);
  }

  /** From where a robot believes to be, around what it believes to be in the way. */
  public static PlanTask of(GlobalVarHolder gvh, Point goal, Rectangle bounds, double clearanceMm) {
    return new PlanTask(
        gvh.gps.pose().at(),
        goal,
        bounds,
        gvh.gps.knownObstacles().all(),
        List.of(),
        gvh.plat.moat.parameters().robotRadiusMm(),
        clearanceMm);
  }

  /** The same from another place. */
  PlanTask from(Point newStart) {
    return new PlanTask(newStart, goal, bounds, obstacles, taken, bodyRadiusMm, clearanceMm);
  }

  /** How far the path, a line, stays from everything. */
  double marginMm() {
    return bodyRadiusMm + clearanceMm;
  }
}
