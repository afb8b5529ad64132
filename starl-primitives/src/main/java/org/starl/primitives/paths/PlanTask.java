package org.starl.primitives.paths;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;

/**
 * A planning problem, as an immutable snapshot. All lengths are in mm; start and goal are rounded
 * to whole mm.
 *
 * @param bounds the floor: the body stays inside
 * @param obstacles they must not move while the path is driven
 * @param taken areas of other robots, to avoid like obstacles
 * @param keepOut areas that the body's centre must not enter; not widened, their borders are free
 * @param bodyRadiusMm the radius of the body, a disc; above 0
 * @param clearanceMm the least distance from the body to anything else, at least 0
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

  /** The largest absolute coordinate, in mm, so that sums and products stay exact. */
  public static final int MAX_MM = 1 << 27;

  public PlanTask {
    taken = List.copyOf(taken);
    keepOut = List.copyOf(keepOut);
    boolean sizes = bodyRadiusMm > 0 && clearanceMm >= 0 && bodyRadiusMm + clearanceMm <= MAX_MM;
    if (!sizes || !start.isFinite() || !goal.isFinite()) {
      throw new IllegalArgumentException(
          String.format(
              "plan from %s to %s, body %s mm, clearance %s mm: expected numbers, the body above 0",
              start, goal, bodyRadiusMm, clearanceMm));
    }
    if (!isPlannable(bounds)) {
      throw new IllegalArgumentException("bounds " + bounds + ": expected within 134 km of 0");
    }
  }

  /** Whether bounds are within {@link #MAX_MM}. */
  public static boolean isPlannable(Rectangle bounds) {
    return bounds.xMinMm() >= -MAX_MM
        && bounds.yMinMm() >= -MAX_MM
        && bounds.xMaxMm() <= MAX_MM
        && bounds.yMaxMm() <= MAX_MM;
  }

  /** Creates a task without {@code keepOut} areas. */
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

  /** Creates a task from a robot's estimated position and its known obstacles. */
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

  /** The same task with another start. */
  PlanTask from(Point newStart) {
    return new PlanTask(
        newStart, goal, bounds, obstacles, taken, keepOut, bodyRadiusMm, clearanceMm);
  }

  /** The same task with another clearance. */
  public PlanTask withClearanceMm(double newMm) {
    return new PlanTask(start, goal, bounds, obstacles, taken, keepOut, bodyRadiusMm, newMm);
  }

  /** The least distance from the path, a line, to anything else. */
  double marginMm() {
    return bodyRadiusMm + clearanceMm;
  }
}
