package org.starl.apps.maze.spec;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.apps.maze.logic.Errand;
import org.starl.apps.maze.logic.Goal;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * The floor as it is, and what the robots are to do on it.
 *
 * @param obstacles hidden ones included
 * @param errands of each robot
 */
public record MazeTruth(
    Rectangle floor, Obstacles obstacles, SortedMap<RobotId, Errand> errands, double bodyMm) {

  public MazeTruth {
    errands = new TreeMap<>(errands);
  }

  @Nullable Goal goal(RobotId robot, String name) {
    Errand errand = errands.get(robot);
    if (errand != null) {
      for (Goal goal : errand.goals()) {
        if (goal.name().equals(name)) {
          return goal;
        }
      }
    }
    return null;
  }

  /**
   * Whether a body that is wider by the margin gets from the robot's start to the goal, nobody else
   * being there.
   */
  boolean leadsTo(RobotId robot, Goal goal) {
    Errand errand = errands.get(robot);
    if (errand == null) {
      return false;
    }
    PlanTask task =
        new PlanTask(
            errand.start(), goal.at(), floor, obstacles, List.of(), bodyMm, Errand.MARGIN_MM);
    return new LocalPlanner().plan(task) instanceof Plan.Found;
  }

  /** Whether a body that is wider by the margin is clear of everything with its centre there. */
  boolean isRoomAt(Point center) {
    return obstacles.distanceMm(center) > bodyMm + Errand.MARGIN_MM;
  }
}
