package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Line of sight: two points see each other unless a side of an obstacle cuts or touches the
 * straight line between them. Robots' bodies hide nothing. Immutable.
 */
public final class Sight {

  /** The corners of a cell are tested this far inside: on a wall's face they belong to the wall. */
  private static final double INSET_MM = 1;

  private final List<Segment> sides;

  private Sight(List<Segment> sides) {
    this.sides = sides;
  }

  static Sight of(Obstacles obstacles) {
    List<Segment> sides = new ArrayList<>();
    for (Obstacle obstacle : obstacles.all()) {
      sides.addAll(obstacle.sides());
    }
    return new Sight(sides);
  }

  /** The same for points within {@code reachMm} of {@code middle} along each axis, and faster. */
  public Sight near(Point middle, double reachMm) {
    List<Segment> near = new ArrayList<>();
    for (Segment side : sides) {
      if (boxesMeet(
          side,
          middle.xMm() - reachMm,
          middle.yMm() - reachMm,
          middle.xMm() + reachMm,
          middle.yMm() + reachMm)) {
        near.add(side);
      }
    }
    return new Sight(near);
  }

  public boolean sees(Point from, Point to) {
    return sees(from.xMm(), from.yMm(), to.xMm(), to.yMm());
  }

  private boolean sees(double px, double py, double qx, double qy) {
    for (Segment side : sides) {
      if (boxesMeet(side, px, py, qx, qy) && cuts(side, px, py, qx, qy)) {
        return false;
      }
    }
    return true;
  }

  /**
   * Whether all of a square cell is in sight and within {@code rangeMm}, wherever the sensor is in
   * the square of half side {@code errorMm} around {@code at}. Tests the cell's centre and corners
   * from the middle and the corners of that square; a corner that a wall cuts off from the cell's
   * own centre does not count.
   */
  boolean seesAll(Point at, double errorMm, Point centre, double halfMm, double rangeMm) {
    double dx = Math.abs(at.xMm() - centre.xMm()) + errorMm + halfMm;
    double dy = Math.abs(at.yMm() - centre.yMm()) + errorMm + halfMm;
    if (StrictMath.sqrt(dx * dx + dy * dy) > rangeMm
        || !seesFromAll(at, errorMm, centre.xMm(), centre.yMm())) {
      return false;
    }
    double inner = halfMm - INSET_MM;
    for (int corner = 0; corner < 4; corner++) {
      double x = centre.xMm() + ((corner & 1) == 0 ? -inner : inner);
      double y = centre.yMm() + ((corner & 2) == 0 ? -inner : inner);
      if (!seesFromAll(at, errorMm, x, y) && sees(centre.xMm(), centre.yMm(), x, y)) {
        return false;
      }
    }
    return true;
  }

  private boolean seesFromAll(Point at, double errorMm, double x, double y) {
    boolean isSeen = sees(at.xMm(), at.yMm(), x, y);
    for (int corner = 0; corner < 4 && errorMm > 0 && isSeen; corner++) {
      double fromX = at.xMm() + ((corner & 1) == 0 ? -errorMm : errorMm);
      double fromY = at.yMm() + ((corner & 2) == 0 ? -errorMm : errorMm);
      isSeen = sees(fromX, fromY, x, y);
    }
    return isSeen;
  }

  private static boolean boxesMeet(Segment side, double px, double py, double qx, double qy) {
    Point a = side.from();
    Point b = side.to();
    return Math.max(a.xMm(), b.xMm()) >= Math.min(px, qx)
        && Math.min(a.xMm(), b.xMm()) <= Math.max(px, qx)
        && Math.max(a.yMm(), b.yMm()) >= Math.min(py, qy)
        && Math.min(a.yMm(), b.yMm()) <= Math.max(py, qy);
  }

  /**
   * Of lines whose boxes meet: whether neither has both its ends strictly on one side of the other.
   */
  private static boolean cuts(Segment side, double px, double py, double qx, double qy) {
    double x = side.from().xMm();
    double y = side.from().yMm();
    double u = side.to().xMm();
    double v = side.to().yMm();
    double ofA = (qx - px) * (y - py) - (qy - py) * (x - px);
    double ofB = (qx - px) * (v - py) - (qy - py) * (u - px);
    double ofP = (u - x) * (py - y) - (v - y) * (px - x);
    double ofQ = (u - x) * (qy - y) - (v - y) * (qx - x);
    return !((ofA > 0 && ofB > 0) || (ofA < 0 && ofB < 0))
        && !((ofP > 0 && ofQ > 0) || (ofP < 0 && ofQ < 0));
  }
}
