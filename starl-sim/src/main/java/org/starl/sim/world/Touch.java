package org.starl.sim.world;

/**
 * The effect of a contact on a body. The bearing of a contact is its direction from the body's
 * centre, relative to the heading, counter-clockwise.
 */
final class Touch {

  /** A contact within this angle of straight ahead presses both bump sensors. */
  static final double BOTH_RAD = StrictMath.toRadians(15);

  private static final double FRONT_RAD = StrictMath.PI / 2;

  /** Below this gap a body may only drive away, at least this steeply: the sine, and the angle. */
  private static final double DEEP_MM = 0.25;

  private static final double LEAVING = 0.02;
  private static final double LEAVING_RAD = StrictMath.asin(LEAVING);

  /** A tolerance, so that rounding does not block a body that drives along a wall. */
  private static final double ALONG = 1e-6;

  /** Bearings, on both sides, at which bumps or pressing change. */
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

  /**
   * Seconds until the bearing of a contact at {@code bearingRad} crosses an edge while the body
   * turns on the spot; infinite if it does not turn.
   */
  static double secondsToEdge(double bearingRad, double radPerS) {
    if (radPerS == 0) {
      return Double.POSITIVE_INFINITY;
    }
    // The bearing turns in the opposite direction of the body.
    double best = Double.POSITIVE_INFINITY;
    for (double edge : EDGES_RAD) {
      best = Math.min(best, aheadRad(bearingRad, edge, -radPerS));
      best = Math.min(best, aheadRad(bearingRad, -edge, -radPerS));
    }
    return best / Math.abs(radPerS);
  }

  /** The angle from {@code bearingRad} to {@code edge} in the direction of {@code sign}. */
  private static double aheadRad(double bearingRad, double edge, double sign) {
    double turn = sign > 0 ? edge - bearingRad : bearingRad - edge;
    return turn > 0 ? turn : turn + 2 * StrictMath.PI;
  }
}
