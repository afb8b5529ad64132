package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

/** What stands at an intersection: the kerbs of its lanes, which cars know; debris, which they don't. */
final class Floor {

  // In zone widths from the middle: lanes are walled between these.
  private static final double KERB_FROM = 1;
  private static final double KERB_TO = 3;

  private static final double DEBRIS_HALF_MM = 30;
  private static final long MIN_DEBRIS_MS = 5_000;
  private static final long MAX_DEBRIS_MS = 30_000;

  // Roadside units stand so far from the middle, behind the kerbs.
  private static final double CORNER = 1.45;

  private Floor() {}

  /** Where the roadside units of an open road stand: at three of the four corners. */
  static List<Pose> roadsideUnits(Crossing crossing) {
    double mm = CORNER * crossing.zoneWidthMm();
    return List.of(
        Pose.of(crossing.middle().plus(new Point(-mm, mm)), 0),
        Pose.of(crossing.middle().plus(new Point(mm, mm)), 0),
        Pose.of(crossing.middle().plus(new Point(mm, -mm)), 0));
  }

  /** Both sides and the middle line of each arm, as in the original StarL's intersection. */
  static Obstacles kerbs(Crossing crossing) {
    List<Obstacle> kerbs = new ArrayList<>();
    double width = crossing.zoneWidthMm();
    for (int side = -1; side <= 1; side++) {
      for (int sign : new int[] {-1, 1}) {
        double across = side * width;
        double from = sign * KERB_FROM * width;
        double to = sign * KERB_TO * width;
        kerbs.add(wall(crossing, new Point(from, across), new Point(to, across)));
        kerbs.add(wall(crossing, new Point(across, from), new Point(across, to)));
      }
    }
    return new Obstacles(kerbs);
  }

  /**
   * {@code pieces} hidden squares of 60 mm in the middle of critical zones, each of which somebody
   * clears away after 5 to 30 s: what cars bump into.
   */
  static Obstacles withDebris(Obstacles obstacles, Crossing crossing, int pieces, Rng rng) {
    Obstacles all = obstacles;
    for (int i = 0; i < pieces; i++) {
      Zone zone = Zone.values()[rng.nextInt(Zone.values().length)];
      Point at = crossing.centre(zone);
      all = all.plus(debris(at, rng.nextLong(MIN_DEBRIS_MS, MAX_DEBRIS_MS)));
    }
    return all;
  }

  private static Obstacle debris(Point at, long lifetimeMs) {
    List<Point> corners =
        List.of(
            at.plus(new Point(-DEBRIS_HALF_MM, -DEBRIS_HALF_MM)),
            at.plus(new Point(DEBRIS_HALF_MM, -DEBRIS_HALF_MM)),
            at.plus(new Point(DEBRIS_HALF_MM, DEBRIS_HALF_MM)),
            at.plus(new Point(-DEBRIS_HALF_MM, DEBRIS_HALF_MM)));
    return new Obstacle(corners, true, true, lifetimeMs);
  }

  private static Obstacle wall(Crossing crossing, Point from, Point to) {
    return Obstacle.wall(crossing.middle().plus(from), crossing.middle().plus(to));
  }
}
