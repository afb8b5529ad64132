package org.starl.primitives.paths;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;

/**
 * Plans from the robot's place, or from a free place near it. Planners add a margin for rounding
 * that tubes do not have. So if another robot's tube passes close by, the planner may report the
 * robot's place as blocked, and the other robot's place too if it stops there. Without another
 * start point, neither robot could ever leave. The whole body must fit in the tube's disc at the
 * start point.
 *
 * @param here the estimated position of the robot
 * @param reachMm the largest distance from {@code here} to the start of the path
 */
record Departure(Point here, double reachMm) {

  /** The search tries this many directions on each circle around the start. */
  private static final int DIRECTIONS = 16;

  /** The ratio of the radius of one circle to the radius before. */
  private static final double GROWTH = 1.25;

  /** Plans from the task's start if it is free, otherwise from a free place close to it. */
  Plan plan(PathPlanner planner, PlanTask task) {
    Plan plan = planner.plan(task);
    if (!plan.equals(new Plan.Blocked(Plan.End.START))) {
      return plan;
    }
    Point free = freeNear(task);
    return free == null ? plan : planner.plan(task.from(free));
  }

  private @Nullable Point freeNear(PlanTask task) {
    FreeSpace space = FloorPlan.of(task);
    double farthestMm = reachMm + here.distanceMm(task.start());
    for (double mm = 1; mm <= farthestMm; mm = Math.max(mm + 1, mm * GROWTH)) {
      for (int i = 0; i < DIRECTIONS; i++) {
        double rad = 2 * StrictMath.PI * i / DIRECTIONS;
        Point there = new Point(mm * StrictMath.cos(rad), mm * StrictMath.sin(rad));
        Point place = Tube.rounded(task.start().plus(there));
        boolean free = space.isFree(FreeSpace.x(place), FreeSpace.y(place));
        if (free && place.distanceMm(here) <= reachMm) {
          return place;
        }
      }
    }
    return null;
  }
}
