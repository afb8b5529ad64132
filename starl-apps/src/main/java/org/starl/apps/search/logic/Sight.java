package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;

/**
 * What can be seen from where: everything to which no side of an obstacle cuts the straight line; a
 * line that touches a side is cut. Robots' bodies hide nothing. Immutable.
 */
public final class Sight {

  private static final int BUCKET_MM = 1_000;

  /** Corners of a cell are looked at so far inside: those on a wall's face belong to the wall. */
  private static final double INSET_MM = 1;

  private final double[] ax;
  private final double[] ay;
  private final double[] bx;
  private final double[] by;
  private final Grid buckets;
  private final int[][] sidesIn;

  public Sight(Obstacles obstacles, Rectangle bounds) {
    List<Segment> sides = new ArrayList<>();
    for (Obstacle obstacle : obstacles.all()) {
      sides.addAll(obstacle.sides());
    }
    int count = sides.size();
    ax = new double[count];
    ay = new double[count];
    bx = new double[count];
    by = new double[count];
    buckets = new Grid(bounds, BUCKET_MM);
    sidesIn = new int[buckets.count()][0];
    for (int i = 0; i < count; i++) {
      ax[i] = sides.get(i).from().xMm();
      ay[i] = sides.get(i).from().yMm();
      bx[i] = sides.get(i).to().xMm();
      by[i] = sides.get(i).to().yMm();
      file(i);
    }
  }

  /** Whether nothing solid is on the line between two points of the floor. */
  public boolean sees(Point from, Point to) {
    return sees(from.xMm(), from.yMm(), to.xMm(), to.yMm());
  }

  boolean sees(double px, double py, double qx, double qy) {
    int fromColumn = clamp(buckets.column(Math.min(px, qx)), buckets.columns());
    int toColumn = clamp(buckets.column(Math.max(px, qx)), buckets.columns());
    int fromRow = clamp(buckets.row(Math.min(py, qy)), buckets.rows());
    int toRow = clamp(buckets.row(Math.max(py, qy)), buckets.rows());
    for (int row = fromRow; row <= toRow; row++) {
      for (int column = fromColumn; column <= toColumn; column++) {
        for (int side : sidesIn[buckets.cell(column, row)]) {
          if (cuts(side, px, py, qx, qy)) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /**
   * Whether all of a square cell that is not cut off from its centre by a wall is in sight, and within
   * {@code rangeMm}, from wherever in the square of half side {@code errorMm} around {@code at} the
   * sensor truly is: its centre and its corners are, from the middle and from each corner.
   */
  public boolean seesAll(Point at, double errorMm, Point centre, double halfMm, double rangeMm) {
    double far = farthestMm(at, errorMm, centre, halfMm);
    if (far > rangeMm || !seesFromAll(at, errorMm, centre.xMm(), centre.yMm())) {
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

  /** From the farthest place of one square to the farthest one of the other. */
  private static double farthestMm(Point at, double errorMm, Point centre, double halfMm) {
    double dx = Math.abs(at.xMm() - centre.xMm()) + errorMm + halfMm;
    double dy = Math.abs(at.yMm() - centre.yMm()) + errorMm + halfMm;
    return StrictMath.sqrt(dx * dx + dy * dy);
  }

  private boolean seesFromAll(Point at, double errorMm, double x, double y) {
    if (!sees(at.xMm(), at.yMm(), x, y)) {
      return false;
    }
    for (int corner = 0; corner < 4 && errorMm > 0; corner++) {
      double fromX = at.xMm() + ((corner & 1) == 0 ? -errorMm : errorMm);
      double fromY = at.yMm() + ((corner & 2) == 0 ? -errorMm : errorMm);
      if (!sees(fromX, fromY, x, y)) {
        return false;
      }
    }
    return true;
  }

  private void file(int side) {
    int fromColumn = clamp(buckets.column(Math.min(ax[side], bx[side])), buckets.columns());
    int toColumn = clamp(buckets.column(Math.max(ax[side], bx[side])), buckets.columns());
    int fromRow = clamp(buckets.row(Math.min(ay[side], by[side])), buckets.rows());
    int toRow = clamp(buckets.row(Math.max(ay[side], by[side])), buckets.rows());
    for (int row = fromRow; row <= toRow; row++) {
      for (int column = fromColumn; column <= toColumn; column++) {
        int bucket = buckets.cell(column, row);
        int[] before = sidesIn[bucket];
        int[] after = Arrays.copyOf(before, before.length + 1);
        after[before.length] = side;
        sidesIn[bucket] = after;
      }
    }
  }

  /** What lies off the floor is filed at its border. */
  private static int clamp(int index, int count) {
    return Math.max(0, Math.min(count - 1, index));
  }

  private boolean cuts(int side, double px, double py, double qx, double qy) {
    double x = ax[side];
    double y = ay[side];
    double u = bx[side];
    double v = by[side];
    if (Math.max(x, u) < Math.min(px, qx)
        || Math.min(x, u) > Math.max(px, qx)
        || Math.max(y, v) < Math.min(py, qy)
        || Math.min(y, v) > Math.max(py, qy)) {
      return false;
    }
    double ofA = (qx - px) * (y - py) - (qy - py) * (x - px);
    double ofB = (qx - px) * (v - py) - (qy - py) * (u - px);
    double ofP = (u - x) * (py - y) - (v - y) * (px - x);
    double ofQ = (u - x) * (qy - y) - (v - y) * (qx - x);
    // Each one's ends are not both strictly on one side of the other; the boxes meet.
    return !((ofA > 0 && ofB > 0) || (ofA < 0 && ofB < 0))
        && !((ofP > 0 && ofQ > 0) || (ofP < 0 && ofQ < 0));
  }
}
