package org.starl.sim.record;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.RandomAccess;
import org.starl.geometry.Point;

/**
 * The past positions of a body: an append-only list of points. A copy shares them until it adds its
 * own; the original may continue in the same memory, beyond the range that the copy reads.
 */
final class Trail extends AbstractList<Point> implements RandomAccess {

  private static final int FIRST_POINTS = 8;

  private double[] xyMm;
  private int points;
  private boolean mayAppend;

  Trail() {
    this(new double[2 * FIRST_POINTS], 0, true);
  }

  private Trail(double[] xyMm, int points, boolean mayAppend) {
    this.xyMm = xyMm;
    this.points = points;
    this.mayAppend = mayAppend;
  }

  /** The same points, to go on apart. */
  Trail copy() {
    return new Trail(xyMm, points, false);
  }

  void append(Point point) {
    if (!mayAppend || 2 * points == xyMm.length) {
      xyMm = Arrays.copyOf(xyMm, Math.max(xyMm.length, 4 * points));
      mayAppend = true;
    }
    xyMm[2 * points] = point.xMm();
    xyMm[2 * points + 1] = point.yMm();
    points++;
  }

  @Override
  public Point get(int index) {
    if (index < 0 || index >= points) {
      throw new IndexOutOfBoundsException("point " + index + " of " + points);
    }
    return new Point(xyMm[2 * index], xyMm[2 * index + 1]);
  }

  @Override
  public int size() {
    return points;
  }
}
