package org.starl.geometry;

/** The empty region. */
public record Nowhere() implements Region {

  @Override
  public boolean contains(Point point) {
    return false;
  }

  @Override
  public double distanceMm(Point point) {
    return Double.POSITIVE_INFINITY;
  }

  @Override
  public double depthMm(Point point) {
    return 0;
  }

  @Override
  public String toString() {
    return RegionText.format(this);
  }
}
