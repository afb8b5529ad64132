package org.starl.sim.world;

import org.starl.body.Bumps;

/**
 * What a contact means to a body. The bearing of a contact is its direction seen from the body's
 * centre, relative to the heading, counter-clockwise.
 */
final class Touch {

  /** A contact this far to either side of straight ahead presses both bump sensors. */
  static final double BOTH_RAD = StrictMath.toRadians(15);

  private static final double FRONT_RAD = StrictMath.PI / 2;

  /** Below this gap a body may only leave, at least this steeply: its sine, and the angle. */
  private static final double DEEP_MM = 0.25;

  private static final double LEAVING = 0.02;
  private static final double LEAVING_RAD = StrictMath.asin(LEAVING);

  /** So that rounding does not hold a body that drives along a wall. */
  private static final double ALONG = 1e-6;

  /** Bearings at which bumps or pressing change, to either side. */
  private static final double[] EDGES_RAD = {
    BOTH_RAD, FRONT_RAD - LEAVING_RAD, FRONT_RAD, FRONT_RAD + LEAVING_RAD
  };

  private Touch() {}

  /** Whether driving at {@code mmPerS} leads into a contact at {@code bearingRad}. */
  static boolean presses(double mmPerS, double bearingRad, double gapMm) {
    if (mmPerS == 0) {
      return false;
    }
    double towards = StrictMath.cos(bearingRad) * (mmPerS > 0 ? 1 : -1);
    return towards > (gapMm < DEEP_MM ? -LEAVING : ALONG);
  }

  static boolean pressesLeft(double bearingRad) {
    return bearingRad >= -BOTH_RAD && bearingRad <= FRONT_RAD;
  }

  static boolean pressesRight(double bearingRad) {
    return bearingRad <= BOTH_RAD && bearingRad >= -FRONT_RAD;
  }

  static Bumps bumps(double bearingRad) {
    return Bumps.of(pressesLeft(bearingRad), pressesRight(bearingRad));
  }

  /**
   * Seconds until a contact at {@code bearingRad} is seen across one of the edges, by a body that
   * turns on the spot; infinite if it does not turn.
   */
  static double secondsToEdge(double bearingRad, double radPerS) {
    if (radPerS == 0) {
      return Double.POSITIVE_INFINITY;
    }
    // The body turns one way, so the bearing turns the other way.
    double best = Double.POSITIVE_INFINITY;
    for (double edge : EDGES_RAD) {
      best = Math.min(best, aheadRad(bearingRad, edge, -radPerS));
      best = Math.min(best, aheadRad(bearingRad, -edge, -radPerS));
    }
    return best / Math.abs(radPerS);
  }

  /** How far a bearing must turn, in the direction of {@code sign}, to get to {@code edge}. */
  private static double aheadRad(double bearingRad, double edge, double sign) {
    double turn = sign > 0 ? edge - bearingRad : bearingRad - edge;
    return turn > 0 ? turn : turn + 2 * StrictMath.PI;
  }
}
