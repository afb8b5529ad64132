package org.starl.geometry;

/** Angles in radians, counter-clockwise. */
public final class Angles {

  private static final double TURN = 2 * StrictMath.PI;

  /** Slightly less than three half turns. */
  private static final double MOST_FAST = 9;

  private Angles() {}

  /** The same angle, normalized to (-pi, pi]. */
  public static double normalize(double angleRad) {
    if (angleRad > -StrictMath.PI && angleRad <= StrictMath.PI) {
      return angleRad;
    }
    // One turn too much, as most sums and differences have: this subtraction is exact (Sterbenz).
    if (angleRad > 0 && angleRad < MOST_FAST) {
      return angleRad - TURN;
    }
    if (angleRad < 0 && angleRad > -TURN) {
      return angleRad + TURN;
    }
    // IEEEremainder is exact and lies in [-pi, pi].
    double rest = StrictMath.IEEEremainder(angleRad, TURN);
    return rest <= -StrictMath.PI ? StrictMath.PI : rest;
  }

  /** The turn from direction {@code from} to direction {@code to}, in (-pi, pi]. */
  public static double difference(double to, double from) {
    return normalize(to - from);
  }

  /** Converts degrees, as in files and settings, to radians. */
  public static double fromDegrees(double degrees) {
    return degrees * (StrictMath.PI / 180);
  }

  /** Converts radians to degrees. */
  public static double toDegrees(double angleRad) {
    return angleRad * (180 / StrictMath.PI);
  }
}
