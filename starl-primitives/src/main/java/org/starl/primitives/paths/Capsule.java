package org.starl.primitives.paths;

import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * All points within {@code radiusMm} of a line: what a disc sweeps that is driven along it. A disc if
 * the line is a point.
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

  /** Whether a disc lies in it for certain, up to rounding: so if it is not close to the border. */
  public boolean containsDisc(Point center, double discRadiusMm) {
    return axis.distanceMm(center) + discRadiusMm <= radiusMm;
  }

  /** Below 0 by how far they overlap, 0 where they touch. */
  public double distanceMm(Capsule other) {
    return axis.distanceMm(other.axis) - radiusMm - other.radiusMm;
  }
}
