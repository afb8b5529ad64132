package org.starl.apps.search.logic;

import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.PathPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * Takes the straight way if it is free for certain, without any plan of the floor, which is much more
 * work; most ways in a sweep are straight. Else the path is as the planner makes it. Immutable.
 */
final class StraightFirst implements PathPlanner {

  /** So much clearance is kept besides, for ends are rounded to whole mm. */
  static final double ROUNDING_MM = 2;

  private final PathPlanner planner;

  StraightFirst(PathPlanner planner) {
    this.planner = planner;
  }

  @Override
  public Plan plan(PlanTask task) {
    Segment way = new Segment(rounded(task.start()), rounded(task.goal()));
    boolean isFree = task.keepOut().isEmpty() && !way.from().equals(way.to()) && isFree(way, task);
    return isFree ? new Plan.Found(new Path(List.of(way.from(), way.to()))) : planner.plan(task);
  }

  private static boolean isFree(Segment way, PlanTask task) {
    double marginMm = task.bodyRadiusMm() + task.clearanceMm() + ROUNDING_MM;
    if (task.bounds().depthMm(way.from()) < marginMm
        || task.bounds().depthMm(way.to()) < marginMm) {
      return false;
    }
    for (Capsule capsule : task.taken()) {
      if (way.distanceMm(capsule.axis()) < capsule.radiusMm() + marginMm) {
        return false;
      }
    }
    for (Obstacle obstacle : task.obstacles().all()) {
      if (obstacle.distanceMm(way.from()) < marginMm) {
        return false; // in the midst of it, too
      }
      for (Segment side : obstacle.sides()) {
        if (way.distanceMm(side) < marginMm) {
          return false;
        }
      }
    }
    return true;
  }

  private static Point rounded(Point point) {
    return new Point(StrictMath.rint(point.xMm()), StrictMath.rint(point.yMm()));
  }
}
