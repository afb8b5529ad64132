package org.starl.primitives.paths;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;

/**
 * Plans from where a robot stands. A way may begin at any place so near that the whole body is inside
 * the disc there. It must be ready to: planners keep a little farther from everything than tubes must,
 * for the sake of rounding, so that a robot is not free for them where another one's tube leads right
 * past it, nor is that other one if it stopped there. If neither could begin elsewhere, neither would
 * ever leave.
 *
 * @param here where the robot is, as far as it knows
 * @param reachMm no way begins farther from there
 */
record Departure(Point here, double reachMm) {

  /** Places are tried around the start, in so many directions, each time so much farther from it. */
  private static final int DIRECTIONS = 16;

  private static final double WIDER = 1.25;

  /** From the task's start if that is free, else from a free place about as near to it as there is. */
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
    for (double mm = 1; mm <= farthestMm; mm = Math.max(mm + 1, mm * WIDER)) {
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
