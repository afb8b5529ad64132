package org.starl.apps.maze.spec;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.maze.logic.Errand;
import org.starl.apps.maze.logic.Goal;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * The true floor, and the robots' tasks on it.
 *
 * @param obstacles hidden ones included
 * @param errands of each robot
 */
public record MazeTruth(Obstacles obstacles, SortedMap<RobotId, Errand> errands, double bodyMm) {

  public MazeTruth {
    errands = new TreeMap<>(errands);
  }

  /** The robot's goals; none for a robot that is not known. */
  List<Goal> goals(RobotId robot) {
    return Optional.ofNullable(errands.get(robot)).map(Errand::goals).orElse(List.of());
  }

  /**
   * Whether there is a way from the robot's start to the goal for a body that is wider by the margin, if
   * no other robot is on the floor.
   */
  boolean leadsTo(RobotId robot, Goal goal) {
    Errand errand = errands.get(robot);
    return errand != null && leadsTo(errand, goal, obstacles, List.of(), bodyMm);
  }

  /** The same for any obstacles, past {@code others}. */
  public static boolean leadsTo(
      Errand errand, Goal goal, Obstacles obstacles, List<Capsule> others, double bodyMm) {
    PlanTask task =
        new PlanTask(
            errand.start(), goal.at(), errand.floor(), obstacles, others, bodyMm, Errand.MARGIN_MM);
    return new LocalPlanner().plan(task) instanceof Plan.Found;
  }

  /** Whether a body that is wider by the margin touches nothing with its centre there. */
  boolean isRoomAt(Point center) {
    return obstacles.distanceMm(center) > bodyMm + Errand.MARGIN_MM;
  }
}
