package org.starl.primitives.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.starl.body.MotionParameters;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Segment;
import org.starl.geometry.Union;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * The way of a motion: straight if there is room, else a shortest one around the region to avoid and
 * the known obstacles.
 *
 * @param errorMm the error bound of the start
 */
record Detour(
    Point start, double errorMm, Point target, Region avoid, Obstacles known, MotionParameters p) {

  private static final double LEAST_STEP_MM = 1;

  /** Whether the straight way has room. Quick, unlike {@link #corners}. */
  boolean isStraight() {
    double neededMm = p.robotRadiusMm() + easyMm();
    return isClear(start, target, neededMm, avoid::distanceMm)
        && isClear(start, target, neededMm, known::distanceMm);
  }

  /** Room for the position error and for passing corners, and such that it need not slow down. */
  private double easyMm() {
    return errorMm + p.goalRadiusMm() + p.linSpeedMaxMmPerS() * p.reachS();
  }

  /**
   * Whether every point of a straight line is at least {@code neededMm} away, if no distance changes
   * faster than the place.
   */
  static boolean isClear(
      Point start, Point target, double neededMm, ToDoubleFunction<Point> distanceMm) {
    Point way = target.minus(start);
    double lengthMm = way.normMm();
    double atMm = 0;
    while (true) {
      Point at = lengthMm == 0 ? start : start.plus(way.times(atMm / lengthMm));
      double spareMm = distanceMm.applyAsDouble(at) - neededMm;
      if (spareMm <= 0) {
        return false;
      }
      if (atMm >= lengthMm) {
        return true;
      }
      atMm = Math.min(lengthMm, atMm + Math.max(LEAST_STEP_MM, spareMm));
    }
  }

  /**
   * The corners of the way, the target last; none if there is no way. Only the target if an end has no
   * room, or anything is too far away to plan: then the motion finds out.
   */
  List<Point> corners() {
    List<Obstacle> solid = new ArrayList<>(known.all());
    List<Capsule> round = new ArrayList<>();
    List<Point> points = new ArrayList<>(List.of(start, target));
    known.all().forEach(obstacle -> points.addAll(obstacle.points()));
    add(avoid, solid, round, points);
    double bodyMm = p.robotRadiusMm();
    Rectangle box = Rectangle.around(points).widened(4 * (bodyMm + easyMm()));
    if (!PlanTask.isPlannable(box)) {
      return List.of(target);
    }
    Obstacles all = new Obstacles(solid);
    PlanTask task = new PlanTask(start, target, box, all, round, bodyMm, easyMm());
    Plan plan = plan(task);
    if (!(plan instanceof Plan.Found)) {
      plan = plan(task.withClearanceMm(errorMm + p.cornerRadiusMm()));
    }
    return switch (plan) {
      case Plan.Found found -> {
        List<Point> corners = new ArrayList<>(found.path().points());
        // The planner rounds to whole mm.
        corners.set(corners.size() - 1, target);
        yield corners;
      }
      case Plan.NoPath none -> List.of();
      default -> List.of(target);
    };
  }

  /** A body that has bumped stands at what it has touched. */
  private static Plan plan(PlanTask task) {
    return new LocalPlanner().planFromNear(task, (int) (2 * task.clearanceMm()));
  }

  private static void add(
      Region region, List<Obstacle> solid, List<Capsule> round, List<Point> points) {
    switch (region) {
      case Circle circle -> {
        Point at = circle.center();
        // A capsule has a radius.
        round.add(new Capsule(new Segment(at, at), Math.max(1, circle.radiusMm())));
        double sideMm = 2 * circle.radiusMm();
        points.addAll(Rectangle.around(at, sideMm, sideMm).corners());
      }
      case Rectangle box -> add(box.corners(), solid, points);
      case Polygon polygon -> add(polygon.vertices(), solid, points);
      case Union union -> union.parts().forEach(part -> add(part, solid, round, points));
      case Nowhere nowhere -> {}
      // The motion has failed at once: its target is inside.
      case Everywhere everywhere -> {}
    }
  }

  private static void add(List<Point> corners, List<Obstacle> solid, List<Point> points) {
    solid.add(new Obstacle(corners, true, false, Obstacle.FOREVER));
    points.addAll(corners);
  }
}
