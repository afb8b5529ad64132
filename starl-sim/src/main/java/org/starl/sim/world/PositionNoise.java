package org.starl.sim.world;

import org.starl.random.Rng;

/**
 * The error of a fix: drawn independently for each fix (a measurement error, no drift), and never
 * above its bound, so that the error bound of the fix is true.
 *
 * <p>Both coordinates and the heading are normal with half of the bound as deviation; values beyond
 * the bound are drawn again.
 *
 * @param boundMm the measured position lies at most this far from the true one
 * @param boundRad the measured heading is at most this far from the true one
 */
public record PositionNoise(double boundMm, double boundRad) {

  public static final PositionNoise NONE = new PositionNoise(0, 0);

  public PositionNoise {
    if (!(boundMm >= 0) || !(boundRad >= 0) || boundRad > StrictMath.PI) {
      throw new IllegalArgumentException(
          "noise " + boundMm + " mm, " + boundRad + " rad: expected at least 0, at most pi rad");
    }
  }

  /** The sum of both bounds. */
  public PositionNoise plus(PositionNoise other) {
    return new PositionNoise(
        boundMm + other.boundMm, Math.min(StrictMath.PI, boundRad + other.boundRad));
  }

  /** One coordinate: normal with deviation 1/2, truncated to -1..1. */
  static double drawWithinOne(Rng rng) {
    double draw;
    do {
      draw = rng.nextGaussian() / 2;
    } while (Math.abs(draw) > 1);
    return draw;
  }
}
