package org.starl.geometry;

/** A point or a displacement in the plane, in mm. */
public record Point(double xMm, double yMm) {

  public Point plus(Point other) {
    return new Point(xMm + other.xMm, yMm + other.yMm);
  }

  public Point minus(Point other) {
    return new Point(xMm - other.xMm, yMm - other.yMm);
  }

  public Point times(double factor) {
    return new Point(xMm * factor, yMm * factor);
  }

  public double dot(Point other) {
    return xMm * other.xMm + yMm * other.yMm;
  }

  public double cross(Point other) {
    return xMm * other.yMm - yMm * other.xMm;
  }

  public double normMm() {
    return StrictMath.sqrt(dot(this));
  }

  public double distanceMm(Point other) {
    return minus(other).normMm();
  }

  /** Direction from the origin, in (-pi, pi]. */
  public double angleRad() {
    return StrictMath.atan2(yMm, xMm);
  }

  /** Whether both coordinates are finite. */
  public boolean isFinite() {
    return Double.isFinite(xMm) && Double.isFinite(yMm);
  }
}
