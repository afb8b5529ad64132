package org.starl.apps.race.logic;

import org.starl.geometry.Point;

/**
 * A point to which robots race.
 *
 * @param radiusMm a robot is at the point if its centre is within this radius; above 0
 */
public record RacePoint(String name, Point at, double radiusMm) {

  public RacePoint {
    if (!at.isFinite() || !(radiusMm > 0) || !Double.isFinite(radiusMm)) {
      throw new IllegalArgumentException(
          "point " + name + " at " + at + ", radius " + radiusMm + ": expected a radius above 0");
    }
  }
}
