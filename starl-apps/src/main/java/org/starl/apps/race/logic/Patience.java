package org.starl.apps.race.logic;

/**
 * Tells when a robot that does not get to its point may take it from where it is: something stands
 * there, such as a robot that has crashed for good. After three motions in vain, none of which has
 * brought it nearer, a body's length and the point's radius will do, 405 mm for a point of 75 mm and
 * bodies of 165 mm; after each further one as much more. Every motion ends within a bound: so no point
 * holds a race up for ever, wherever it lies. Pure.
 */
public final class Patience {

  private static final int TRIES = 3;
  private static final double NEARER_MM = 50;

  private final RacePoint point;
  private final double bodyRadiusMm;
  private double bestMm = Double.POSITIVE_INFINITY;
  private int inVain;

  public Patience(RacePoint point, double bodyRadiusMm) {
    this.point = point;
    this.bodyRadiusMm = bodyRadiusMm;
  }

  /** Whether it will do that the robot is so far from the point after one more motion in vain. */
  public boolean isEnough(double distanceMm) {
    if (distanceMm < bestMm - NEARER_MM) {
      bestMm = distanceMm;
      inVain = 0;
    }
    inVain++;
    return distanceMm <= allowedMm(point, bodyRadiusMm, inVain);
  }

  /** How far off will do after so many motions in vain; not above 0 if none will. */
  public static double allowedMm(RacePoint point, double bodyRadiusMm, int inVain) {
    return (inVain - TRIES + 1) * (2 * bodyRadiusMm + point.radiusMm());
  }
}
