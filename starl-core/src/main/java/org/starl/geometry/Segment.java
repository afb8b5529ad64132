package org.starl.geometry;

/** A line segment including its ends; a single point if they are equal. */
public record Segment(Point from, Point to) {

  /** The point of the segment nearest to {@code point}. */
  public Point nearest(Point point) {
    Point along = to.minus(from);
    double square = along.dot(along);
    if (square == 0) {
      return from;
    }
    double part = point.minus(from).dot(along) / square;
    if (part >= 1) {
      return to;
    }
    return part <= 0 ? from : from.plus(along.times(part));
  }

  public double distanceMm(Point point) {
    return distanceMm(from.xMm(), from.yMm(), to.xMm(), to.yMm(), point.xMm(), point.yMm());
  }

  /** The distance between two segments; 0 if they have a common point. */
  public double distanceMm(Segment other) {
    if (crosses(other)) {
      return 0;
    }
    return Math.min(
        Math.min(distanceMm(other.from), distanceMm(other.to)),
        Math.min(other.distanceMm(from), other.distanceMm(to)));
  }

  /** Whether two segments have a common point, ends included. */
  public boolean crosses(Segment other) {
    double a = side(other.from);
    double b = side(other.to);
    double c = other.side(from);
    double d = other.side(to);
    if (((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && d < 0) || (c < 0 && d > 0))) {
      return true;
    }
    return (a == 0 && boxContains(other.from))
        || (b == 0 && boxContains(other.to))
        || (c == 0 && other.boxContains(from))
        || (d == 0 && other.boxContains(to));
  }

  /** Whether {@code point} lies on the segment, up to the rounding error of one product. */
  public boolean contains(Point point) {
    return side(point) == 0 && boxContains(point);
  }

  /** Above 0 to the left, below 0 to the right, 0 on the line. */
  private double side(Point point) {
    return to.minus(from).cross(point.minus(from));
  }

  private boolean boxContains(Point p) {
    return Math.min(from.xMm(), to.xMm()) <= p.xMm()
        && p.xMm() <= Math.max(from.xMm(), to.xMm())
        && Math.min(from.yMm(), to.yMm()) <= p.yMm()
        && p.yMm() <= Math.max(from.yMm(), to.yMm());
  }

  /** Distance of (px, py) from the segment (ax, ay), (bx, by); for loops that must not allocate. */
  static double distanceMm(double ax, double ay, double bx, double by, double px, double py) {
    double dx = bx - ax;
    double dy = by - ay;
    double square = dx * dx + dy * dy;
    double part = square == 0 ? 0 : ((px - ax) * dx + (py - ay) * dy) / square;
    double clamped = Math.max(0, Math.min(1, part));
    double ex = px - (ax + dx * clamped);
    double ey = py - (ay + dy * clamped);
    return Math.sqrt(ex * ex + ey * ey);
  }
}
