package org.starl.geometry;

/**
 * A disc.
 *
 * @param radiusMm at least 0
 */
public record Circle(Point center, double radiusMm) implements Region {

  public Circle {
    if (!center.isFinite() || !Double.isFinite(radiusMm) || radiusMm < 0) {
      throw new IllegalArgumentException(
          "circle at " + center + ", radius " + radiusMm + ": expected numbers, radius at least 0");
    }
  }

  @Override
  public boolean contains(Point point) {
    return center.distanceMm(point) <= radiusMm;
  }

  @Override
  public double distanceMm(Point point) {
    return Math.max(0, center.distanceMm(point) - radiusMm);
  }

  @Override
  public double depthMm(Point point) {
    return Math.max(0, radiusMm - center.distanceMm(point));
  }

  @Override
  public String toString() {
    return RegionText.format(this);
  }
}
