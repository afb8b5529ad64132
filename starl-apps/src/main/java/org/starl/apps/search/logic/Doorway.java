package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * A shut door: two lines from the door's point to the walls beside it.
 *
 * @param leaves the two lines; each ends a little way inside its wall
 */
record Doorway(String name, Point at, List<Segment> leaves) {

  /** The walls beside a door are at least 84 degrees apart: the cosine of that angle. */
  private static final double MAX_COSINE = 0.1;

  private static final double OVERLAP_MM = 1;

  /**
   * Shuts a door. Of all pairs of walls that the door's point sees, at least 84 degrees apart,
   * takes the pair with the shortest way from one wall over the point to the other.
   *
   * @throws IllegalArgumentException if there is no such pair
   */
  static Doorway of(ItemPosition door, HousePlan plan, Sight sight) {
    Point at = door.at();
    List<Point> jambs = new ArrayList<>();
    for (Obstacle wall : plan.walls().all()) {
      for (Segment side : wall.sides()) {
        Point jamb = side.nearest(at);
        double mm = jamb.distanceMm(at);
        if (mm > OVERLAP_MM && sight.sees(at, jamb.plus(at.minus(jamb).times(OVERLAP_MM / mm)))) {
          jambs.add(jamb);
        }
      }
    }
    double shortestMm = Double.POSITIVE_INFINITY;
    List<Segment> leaves = List.of();
    for (int i = 0; i < jambs.size(); i++) {
      double leftMm = jambs.get(i).distanceMm(at);
      for (Point right : jambs.subList(i + 1, jambs.size())) {
        double rightMm = right.distanceMm(at);
        double dot = jambs.get(i).minus(at).dot(right.minus(at));
        if (leftMm + rightMm < shortestMm && dot <= MAX_COSINE * leftMm * rightMm) {
          shortestMm = leftMm + rightMm;
          leaves = List.of(leaf(at, jambs.get(i), leftMm), leaf(at, right, rightMm));
        }
      }
    }
    if (leaves.isEmpty()) {
      throw new IllegalArgumentException(
          "door " + door.name() + " at " + at + ": expected a wall on either side");
    }
    return new Doorway(door.name(), at, leaves);
  }

  private static Segment leaf(Point door, Point jamb, double mm) {
    return new Segment(door, jamb.plus(jamb.minus(door).times(OVERLAP_MM / mm)));
  }

  /** Whether the shut door cuts the line between two points. */
  boolean isBetween(Point from, Point to) {
    Segment line = new Segment(from, to);
    return leaves.get(0).crosses(line) || leaves.get(1).crosses(line);
  }

  double distanceMm(Point point) {
    return Math.min(leaves.get(0).distanceMm(point), leaves.get(1).distanceMm(point));
  }
}
