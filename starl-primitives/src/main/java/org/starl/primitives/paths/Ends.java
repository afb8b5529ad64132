package org.starl.primitives.paths;

import org.jspecify.annotations.Nullable;

/** Start and goal of a task, in whole mm. */
record Ends(int startX, int startY, int goalX, int goalY) {

  static Ends of(PlanTask task) {
    return new Ends(
        FreeSpace.x(task.start()),
        FreeSpace.y(task.start()),
        FreeSpace.x(task.goal()),
        FreeSpace.y(task.goal()));
  }

  /** Which end is not free, or null. */
  Plan.@Nullable Blocked blockedIn(FreeSpace space) {
    if (!space.isFree(startX, startY)) {
      return new Plan.Blocked(Plan.End.START);
    }
    return space.isFree(goalX, goalY) ? null : new Plan.Blocked(Plan.End.GOAL);
  }
}
