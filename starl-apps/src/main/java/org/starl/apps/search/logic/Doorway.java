package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * A door that is shut: two lines from the door's point to the walls beside it.
 *
 * @param leaves the two lines, each a little way into its wall
 */
record Doorway(String name, Point at, List<Segment> leaves) {

  /** Two walls beside a door lie in directions at least so far apart, as a cosine: 84 degrees. */
  private static final double MOST_COSINE = 0.1;

  private static final double OVERLAP_MM = 1;

  private record Jamb(Point at, double distanceMm) {}

  /**
   * The doorway of a door: of all pairs of walls that its point sees, in directions at least 84
   * degrees apart, the one with the shortest way from wall to wall over the point.
   *
   * @throws IllegalArgumentException if there are no two such walls
   */
  static Doorway of(ItemPosition door, HousePlan plan, Sight sight) {
    List<Jamb> jambs = new ArrayList<>();
    for (Obstacle wall : plan.walls().all()) {
      for (Segment side : wall.sides()) {
        Point nearest = side.nearest(door.at());
        double distanceMm = nearest.distanceMm(door.at());
        if (distanceMm > OVERLAP_MM && isInView(door.at(), nearest, distanceMm, sight)) {
          jambs.add(new Jamb(nearest, distanceMm));
        }
      }
    }
    Jamb left = null;
    Jamb right = null;
    for (int i = 0; i < jambs.size(); i++) {
      for (int j = i + 1; j < jambs.size(); j++) {
        Jamb a = jambs.get(i);
        Jamb b = jambs.get(j);
        boolean isShorter =
            left == null
                || right == null
                || a.distanceMm() + b.distanceMm() < left.distanceMm() + right.distanceMm();
        if (isShorter && areApart(door.at(), a, b)) {
          left = a;
          right = b;
        }
      }
    }
    if (left == null || right == null) {
      throw new IllegalArgumentException(
          "door " + door.name() + " at " + door.at() + ": expected a wall on either side");
    }
    return new Doorway(
        door.name(), door.at(), List.of(leaf(door.at(), left), leaf(door.at(), right)));
  }

  private static boolean isInView(Point door, Point wall, double distanceMm, Sight sight) {
    Point before = wall.plus(door.minus(wall).times(OVERLAP_MM / distanceMm));
    return sight.sees(door, before);
  }

  private static boolean areApart(Point door, Jamb a, Jamb b) {
    double dot = a.at().minus(door).dot(b.at().minus(door));
    return dot <= MOST_COSINE * a.distanceMm() * b.distanceMm();
  }

  private static Segment leaf(Point door, Jamb jamb) {
    Point beyond = jamb.at().minus(door).times(OVERLAP_MM / jamb.distanceMm());
    return new Segment(door, jamb.at().plus(beyond));
  }

  /** Whether the shut door is on the line between two points. */
  boolean isBetween(Point from, Point to) {
    Segment line = new Segment(from, to);
    return leaves.get(0).crosses(line) || leaves.get(1).crosses(line);
  }

  double distanceMm(Point point) {
    return Math.min(leaves.get(0).distanceMm(point), leaves.get(1).distanceMm(point));
  }
}
