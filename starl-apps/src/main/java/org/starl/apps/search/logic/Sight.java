package org.starl.apps.search.logic;

import java.util.List;
import java.util.stream.Collectors;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Line of sight: two points see each other unless the side of an obstacle cuts or touches the
 * straight line between them. Robots' bodies hide nothing. Immutable.
 */
public final class Sight {

  /** The corners of a cell are tested this far inside: on a wall's face they belong to the wall. */
  private static final double INSET_MM = 1;

  private final List<Segment> sides;

  Sight(List<Segment> sides) {
    this.sides = List.copyOf(sides);
  }

  /** The same for points within {@code reachMm} of {@code middle} along each axis, and faster. */
  public Sight near(Point middle, double reachMm) {
    Point reach = new Point(reachMm, reachMm);
    Point low = middle.minus(reach);
    Point high = middle.plus(reach);
    return new Sight(
        sides.stream().filter(side -> boxesMeet(side, low, high)).collect(Collectors.toList()));
  }

  public boolean sees(Point from, Point to) {
    for (Segment side : sides) {
      if (boxesMeet(side, from, to) && side.crosses(new Segment(from, to))) {
        return false;
      }
    }
    return true;
  }

  /**
   * Whether all of a square cell is in sight from every one of some points. Tests the cell's centre
   * and corners; a corner that a wall cuts off from the cell's own centre does not count.
   */
  boolean seesAll(List<Point> from, Point centre, double halfMm) {
    if (!isSeenFromAll(from, centre)) {
      return false;
    }
    for (Point corner : square(centre, halfMm - INSET_MM)) {
      if (!isSeenFromAll(from, corner) && sees(centre, corner)) {
        return false;
      }
    }
    return true;
  }

  private boolean isSeenFromAll(List<Point> from, Point to) {
    for (Point at : from) {
      if (!sees(at, to)) {
        return false;
      }
    }
    return true;
  }

  /** The middle and the corners of a square. */
  static List<Point> square(Point middle, double halfMm) {
    Point rising = new Point(halfMm, halfMm);
    Point falling = new Point(halfMm, -halfMm);
    return List.of(
        middle,
        middle.plus(rising),
        middle.minus(rising),
        middle.plus(falling),
        middle.minus(falling));
  }

  private static boolean boxesMeet(Segment side, Point p, Point q) {
    Point a = side.from();
    Point b = side.to();
    return Math.max(a.xMm(), b.xMm()) >= Math.min(p.xMm(), q.xMm())
        && Math.min(a.xMm(), b.xMm()) <= Math.max(p.xMm(), q.xMm())
        && Math.max(a.yMm(), b.yMm()) >= Math.min(p.yMm(), q.yMm())
        && Math.min(a.yMm(), b.yMm()) <= Math.max(p.yMm(), q.yMm());
  }
}
