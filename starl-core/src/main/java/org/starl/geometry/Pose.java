package org.starl.geometry;

/** A position in mm and a heading in radians, counter-clockwise from the x axis. */
public record Pose(double xMm, double yMm, double headingRad) {

  public static Pose of(Point at, double headingRad) {
    return new Pose(at.xMm(), at.yMm(), headingRad);
  }

  public Point at() {
    return new Point(xMm, yMm);
  }

  public double distanceMm(Point other) {
    double dx = xMm - other.xMm();
    double dy = yMm - other.yMm();
    return StrictMath.sqrt(dx * dx + dy * dy);
  }
}
