package org.starl.geometry;

import java.util.List;

/** An axis-parallel rectangle; degenerate to a line or a point if its sides are. */
public record Rectangle(double xMinMm, double yMinMm, double xMaxMm, double yMaxMm)
    implements Region {

  public Rectangle {
    boolean finite =
        Double.isFinite(xMinMm)
            && Double.isFinite(yMinMm)
            && Double.isFinite(xMaxMm)
            && Double.isFinite(yMaxMm);
    if (!finite || xMinMm > xMaxMm || yMinMm > yMaxMm) {
      throw new IllegalArgumentException(
          String.format(
              "rectangle x %s..%s, y %s..%s: expected numbers, the smaller one first",
              xMinMm, xMaxMm, yMinMm, yMaxMm));
    }
  }

  /** The rectangle of this size around {@code center}. */
  public static Rectangle around(Point center, double widthMm, double heightMm) {
    return new Rectangle(
        center.xMm() - widthMm / 2,
        center.yMm() - heightMm / 2,
        center.xMm() + widthMm / 2,
        center.yMm() + heightMm / 2);
  }

  /** The bounding rectangle of {@code points}, at least one. */
  public static Rectangle around(List<Point> points) {
    double xMin = Double.POSITIVE_INFINITY;
    double yMin = Double.POSITIVE_INFINITY;
    double xMax = Double.NEGATIVE_INFINITY;
    double yMax = Double.NEGATIVE_INFINITY;
    for (Point point : points) {
      xMin = Math.min(xMin, point.xMm());
      yMin = Math.min(yMin, point.yMm());
      xMax = Math.max(xMax, point.xMm());
      yMax = Math.max(yMax, point.yMm());
    }
    return new Rectangle(xMin, yMin, xMax, yMax);
  }

  /** The rectangle extended by {@code byMm} on each side. */
  public Rectangle widened(double byMm) {
    return new Rectangle(xMinMm - byMm, yMinMm - byMm, xMaxMm + byMm, yMaxMm + byMm);
  }

  public Point center() {
    return new Point((xMinMm + xMaxMm) / 2, (yMinMm + yMaxMm) / 2);
  }

  /** The rectangle, which must have an area, as a polygon, from its lower left corner. */
  public Polygon outline() {
    return new Polygon(corners());
  }

  /** Its corners, from the lower left one on, counterclockwise. */
  public List<Point> corners() {
    return List.of(
        new Point(xMinMm, yMinMm),
        new Point(xMaxMm, yMinMm),
        new Point(xMaxMm, yMaxMm),
        new Point(xMinMm, yMaxMm));
  }

  @Override
  public boolean contains(Point point) {
    return xMinMm <= point.xMm()
        && point.xMm() <= xMaxMm
        && yMinMm <= point.yMm()
        && point.yMm() <= yMaxMm;
  }

  @Override
  public double distanceMm(Point point) {
    double dx = Math.max(0, Math.max(xMinMm - point.xMm(), point.xMm() - xMaxMm));
    double dy = Math.max(0, Math.max(yMinMm - point.yMm(), point.yMm() - yMaxMm));
    return Math.sqrt(dx * dx + dy * dy);
  }

  @Override
  public double depthMm(Point point) {
    double dx = Math.min(point.xMm() - xMinMm, xMaxMm - point.xMm());
    double dy = Math.min(point.yMm() - yMinMm, yMaxMm - point.yMm());
    return Math.max(0, Math.min(dx, dy));
  }

  @Override
  public String toString() {
    return RegionText.format(this);
  }
}
