package org.starl.primitives.paths;

import org.jspecify.annotations.Nullable;

/** Start and goal of a task, in whole mm. */
record Ends(int startX, int startY, int goalX, int goalY) {

  private static final int STEP_MM = 3;
  private static final int DIRECTIONS = 32;

  static Ends of(PlanTask task) {
    return new Ends(
        FreeSpace.x(task.start()),
        FreeSpace.y(task.start()),
        FreeSpace.x(task.goal()),
        FreeSpace.y(task.goal()));
  }

  /** Moves the start to the nearest free place within {@code slackMm}, if there is one. */
  Ends free(FreeSpace space, int slackMm) {
    if (space.isFree(startX, startY)) {
      return this;
    }
    for (int mm = 1; mm <= slackMm; mm += STEP_MM) {
      for (int i = 0; i < DIRECTIONS; i++) {
        double rad = 2 * StrictMath.PI * i / DIRECTIONS;
        int x = startX + (int) StrictMath.rint(mm * StrictMath.cos(rad));
        int y = startY + (int) StrictMath.rint(mm * StrictMath.sin(rad));
        if (space.isFree(x, y)) {
          return new Ends(x, y, goalX, goalY);
        }
      }
    }
    return this;
  }

  /** The end that is not free, or null. */
  Plan.@Nullable Blocked blockedIn(FreeSpace space) {
    if (!space.isFree(startX, startY)) {
      return new Plan.Blocked(Plan.End.START);
    }
    return space.isFree(goalX, goalY) ? null : new Plan.Blocked(Plan.End.GOAL);
  }
}
