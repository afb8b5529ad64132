package org.starl.apps.maze.logic;

import java.util.List;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.motion.Contact;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * One robot's task, and its knowledge of the floor at the start, apart from obstacles.
 *
 * @param start its position at the start of the run
 * @param goals in order
 * @param others discs in which the other robots stand while they hold no block: their starts and
 *     goals
 * @param floor all bodies stay in it
 */
public record MazeTask(
    Point start,
    List<Goal> goals,
    List<Capsule> others,
    Rectangle floor,
    Blocks blocks,
    CollisionMode mode) {

  /** If there is a way for a body that is wider by this on every side, a way is found. */
  public static final double MARGIN_MM = 75;

  // A contact this near to another robot's place may be with that robot.
  private static final double NEAR_MM = 40;

  /**
   * Whether there is a way from the start to a goal for a body that is wider by the margin, past
   * {@code others}.
   */
  public boolean hasWay(Goal goal, Obstacles obstacles, List<Capsule> others, double bodyMm) {
    PlanTask way = new PlanTask(start, goal.at(), floor, obstacles, others, bodyMm, MARGIN_MM);
    return new LocalPlanner().plan(way) instanceof Plan.Found;
  }

  /**
   * Whether a contact may be with another robot that holds no block, and so proves nothing.
   *
   * @param bodyMm radius of the body that was stopped
   */
  boolean mayBeOther(Contact contact, double bodyMm) {
    return isNearOther(contact.at().pose().at(), bodyMm + contact.at().errorMm() + NEAR_MM);
  }

  /** Whether another robot may stand within this distance, holding no block. */
  boolean isNearOther(Point at, double reachMm) {
    return others.stream()
        .anyMatch(other -> other.axis().distanceMm(at) <= reachMm + other.radiusMm());
  }
}
