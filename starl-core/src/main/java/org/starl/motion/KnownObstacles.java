package org.starl.motion;

import java.util.List;
import org.starl.body.Bumps;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;

/**
 * The obstacles that one robot knows: its map at the start, and a small square for each contact.
 * Strand only.
 */
public final class KnownObstacles {

  private static final double SENSOR_RAD = StrictMath.PI / 4;

  private Obstacles obstacles;
  private int contacts;

  KnownObstacles(Obstacles atStart) {
    this.obstacles = atStart;
  }

  /** The current obstacles; immutable, so planners may use it off the strand. */
  public Obstacles all() {
    return obstacles;
  }

  /** Number of contacts added. */
  public int contacts() {
    return contacts;
  }

  /** Adds a square of {@code sideMm} around {@code contact}. */
  public void addContact(Point contact, double sideMm) {
    double x = StrictMath.floor(contact.xMm() / sideMm) * sideMm;
    double y = StrictMath.floor(contact.yMm() / sideMm) * sideMm;
    Obstacle mark =
        Obstacle.body(
            new Point(x, y),
            new Point(x + sideMm, y),
            new Point(x + sideMm, y + sideMm),
            new Point(x, y + sideMm));
    List<Obstacle> now = obstacles.all();
    if (!now.contains(mark)) {
      obstacles = obstacles.plus(mark);
      contacts++;
    }
  }

  /** The point at which a body at {@code pose} touches the object, judged by its bump sensors. */
  static Point contact(Pose pose, Bumps bumps, double radiusMm) {
    double side =
        switch (bumps) {
          case LEFT -> SENSOR_RAD;
          case RIGHT -> -SENSOR_RAD;
          case BOTH, NONE -> 0;
        };
    double direction = pose.headingRad() + side;
    return new Point(
        pose.xMm() + radiusMm * StrictMath.cos(direction),
        pose.yMm() + radiusMm * StrictMath.sin(direction));
  }
}
