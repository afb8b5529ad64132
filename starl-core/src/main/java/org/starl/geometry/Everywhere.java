package org.starl.geometry;

/** The whole plane. */
public record Everywhere() implements Region {

  @Override
  public boolean contains(Point point) {
    return true;
  }

  @Override
  public double distanceMm(Point point) {
    return 0;
  }

  @Override
  public double depthMm(Point point) {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public String toString() {
    return RegionText.format(this);
  }
}
