package org.starl.apps.maze.robot;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.maze.logic.Blocks;
import org.starl.apps.maze.logic.CollisionMode;
import org.starl.apps.maze.logic.Goal;
import org.starl.apps.maze.logic.MazeTask;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.primitives.paths.Capsule;

/**
 * A maze with its robots.
 *
 * @param floor all bodies stay in it
 * @param obstacles hidden ones included
 */
public record Layout(Rectangle floor, Obstacles obstacles, List<Robot> robots) {

  // How far from its place a robot may stand, besides the goal's tolerance.
  private static final double OFF_MM = 10;

  /** One robot: its start, and its goals in turn. */
  public record Robot(Pose start, List<Goal> goals) {}

  /** The task of robot {@code index}. */
  public MazeTask task(int index, double bodyMm, CollisionMode mode) {
    Robot robot = robots.get(index);
    List<Capsule> others = new ArrayList<>();
    for (int i = 0; i < robots.size(); i++) {
      if (i != index) {
        others.add(disc(robots.get(i).start().at(), bodyMm + OFF_MM));
        for (Goal goal : robots.get(i).goals()) {
          others.add(disc(goal.at(), bodyMm + OFF_MM + goal.toleranceMm()));
        }
      }
    }
    return new MazeTask(robot.start().at(), robot.goals(), others, floor, Blocks.of(floor), mode);
  }

  private static Capsule disc(Point center, double radiusMm) {
    return new Capsule(new Segment(center, center), radiusMm);
  }
}
