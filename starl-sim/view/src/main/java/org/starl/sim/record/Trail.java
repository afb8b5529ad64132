package org.starl.sim.record;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.RandomAccess;
import org.starl.geometry.Point;

/**
 * Positions of a body: the first and the latest points; older points in between are sparser. A copy
 * shares the array with its original until the copy appends a point, or one of them removes points
 * or needs a longer array; the original appends behind the part that the copy reads.
 */
final class Trail extends AbstractList<Point> implements RandomAccess {

  private static final int FIRST_POINTS = 8;

  private double[] xyMm;
  private int points;
  private int steps;
  private boolean mayAppend;

  Trail() {
    this(new double[2 * FIRST_POINTS], 0, 0, true);
  }

  private Trail(double[] xyMm, int points, int steps, boolean mayAppend) {
    this.xyMm = xyMm;
    this.points = points;
    this.steps = steps;
    this.mayAppend = mayAppend;
  }

  /** An independent copy with the same points. */
  Trail copy() {
    return new Trail(xyMm, points, steps, false);
  }

  /** Number of points appended so far. */
  int steps() {
    return steps;
  }

  /**
   * Appends a point.
   *
   * @param most greatest number of points; to keep it, every other one of the older half is removed
   */
  void append(Point point, int most) {
    if (points >= most) {
      thin();
    }
    if (!mayAppend || 2 * points == xyMm.length) {
      xyMm = Arrays.copyOf(xyMm, 2 * Math.max(points + 1, Math.min(2 * points, most)));
      mayAppend = true;
    }
    xyMm[2 * points] = point.xMm();
    xyMm[2 * points + 1] = point.yMm();
    points++;
    steps++;
  }

  private void thin() {
    double[] thinner = new double[2 * points];
    int kept = 0;
    for (int i = 0; i < points; i += i < points / 2 ? 2 : 1) {
      thinner[kept++] = xyMm[2 * i];
      thinner[kept++] = xyMm[2 * i + 1];
    }
    xyMm = thinner;
    points = kept / 2;
    mayAppend = true;
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
