package org.starl.apps.intersection.robot;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.random.Rng;

/** Objects at an intersection: kerbs, which cars know; debris, which they do not; roadside units. */
public final class Floor {

  // Distances from the middle in zone widths. Lanes have kerbs between the first two.
  private static final double KERB_FROM = 1;
  private static final double KERB_TO = 3;
  private static final double UNIT = 1.45;

  private static final double DEBRIS_HALF_MM = 30;
  private static final long MIN_DEBRIS_MS = 5_000;
  private static final long MAX_DEBRIS_MS = 30_000;

  private Floor() {}

  /** Where the roadside units of an open road stand: at three of the four corners. */
  public static List<Point> roadsideUnits() {
    return List.of(Crossing.at(-UNIT, UNIT), Crossing.at(UNIT, UNIT), Crossing.at(UNIT, -UNIT));
  }

  /** Both sides and the middle line of each arm, as in the original StarL's intersection. */
  public static Obstacles kerbs() {
    List<Obstacle> kerbs = new ArrayList<>();
    for (int side = -1; side <= 1; side++) {
      for (int sign : new int[] {-1, 1}) {
        double from = sign * KERB_FROM;
        double to = sign * KERB_TO;
        kerbs.add(Obstacle.wall(Crossing.at(from, side), Crossing.at(to, side)));
        kerbs.add(Obstacle.wall(Crossing.at(side, from), Crossing.at(side, to)));
      }
    }
    return new Obstacles(kerbs);
  }

  /**
   * Adds {@code pieces} hidden squares of 60 mm in the middle of critical zones. Each is removed after 5
   * to 30 s.
   */
  public static Obstacles withDebris(Obstacles obstacles, int pieces, Rng rng) {
    Obstacles all = obstacles;
    for (int i = 0; i < pieces; i++) {
      Point at = Crossing.centre(Zone.values()[rng.nextInt(Zone.values().length)]);
      List<Point> corners =
          Rectangle.around(at, 2 * DEBRIS_HALF_MM, 2 * DEBRIS_HALF_MM).outline().vertices();
      long lifetimeMs = rng.nextLong(MIN_DEBRIS_MS, MAX_DEBRIS_MS);
      all = all.plus(new Obstacle(corners, true, true, lifetimeMs));
    }
    return all;
  }
}
