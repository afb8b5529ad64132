package org.starl.primitives.paths;

import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * All points within {@code radiusMm} of a segment: the area swept by a disc that moves along it. A
 * disc if the segment is a point.
 *
 * @param radiusMm above 0
 */
public record Capsule(Segment axis, double radiusMm) {

  public Capsule {
    if (!(radiusMm > 0) || !axis.from().isFinite() || !axis.to().isFinite()) {
      throw new IllegalArgumentException(
          "capsule along " + axis + ", radius " + radiusMm + ": expected numbers, radius above 0");
    }
  }

  /** Whether a disc lies inside, up to rounding. */
  public boolean containsDisc(Point center, double discRadiusMm) {
    return axis.distanceMm(center) + discRadiusMm <= radiusMm;
  }

  /** The distance between the borders: 0 where they touch, below 0 where they overlap. */
  public double distanceMm(Capsule other) {
    return axis.distanceMm(other.axis) - radiusMm - other.radiusMm;
  }
}
