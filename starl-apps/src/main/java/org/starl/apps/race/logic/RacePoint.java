package org.starl.apps.race.logic;

import org.starl.geometry.Point;

/**
 * A point that robots race to.
 *
 * @param radiusMm a robot whose centre is as near as this is there; above 0
 */
public record RacePoint(String name, Point at, double radiusMm) {

  public RacePoint {
    if (!at.isFinite() || !(radiusMm > 0) || !Double.isFinite(radiusMm)) {
      throw new IllegalArgumentException(
          "point " + name + " at " + at + ", radius " + radiusMm + ": expected a radius above 0");
    }
  }
}
