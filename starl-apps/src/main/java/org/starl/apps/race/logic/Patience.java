package org.starl.apps.race.logic;

/**
 * Decides when a robot that does not get to its point may win it from a distance, because something
 * stands there, such as a robot that has crashed for ever. After three motions in vain, none of
 * which has brought it nearer, a body's diameter plus the point's radius is enough (405 mm for a
 * point of 75 mm and bodies of 165 mm); after each further one as much again. Every motion ends
 * within a bound, so no point holds up a race for ever. Pure.
 */
public final class Patience {

  private static final int TRIES = 3;

  /** A motion that has brought the robot less near was in vain. */
  public static final double NEARER_MM = 50;

  private final RacePoint point;
  private final double bodyRadiusMm;
  private double bestMm = Double.POSITIVE_INFINITY;
  private int inVain;

  Patience(RacePoint point, double bodyRadiusMm) {
    this.point = point;
    this.bodyRadiusMm = bodyRadiusMm;
  }

  /** One more motion was in vain: whether the robot may win the point from this distance. */
  boolean recordFailedMotion(double distanceMm) {
    if (distanceMm < bestMm - NEARER_MM) {
      bestMm = distanceMm;
      inVain = 0;
    }
    inVain++;
    return distanceMm <= (inVain - TRIES + 1) * (2 * bodyRadiusMm + point.radiusMm());
  }
}
