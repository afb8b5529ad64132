package org.starl.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.random.Rng;

class SinesTest {

  private static final int MANY = 400_000;

  @Test
  void theyHaveTheBitsOfStrictMathOnAnglesOfManySizes() {
    Rng rng = new Rng(1);
    for (int i = 0; i < MANY; i++) {
      check(rng.nextDouble() * 100);
      check(rng.nextDouble() * 1e6);
      check(rng.nextDouble() * StrictMath.PI);
      check(Double.longBitsToDouble(rng.nextLong(Long.MIN_VALUE, Long.MAX_VALUE)));
    }
  }

  /** There the sum of an angle and a multiple of a quarter turn loses its leading bits. */
  @Test
  void theyHaveTheBitsOfStrictMathNearMultiplesOfAnEighthOfATurn() {
    Rng rng = new Rng(2);
    for (int eighths = 1; eighths <= 200; eighths++) {
      double angle = eighths * (StrictMath.PI / 4);
      double above = angle;
      double below = angle;
      for (int i = 0; i < 1_000; i++) {
        check(above);
        check(below);
        above = Math.nextUp(above);
        below = Math.nextDown(below);
      }
      for (double off = 1; off > 1e-18; off /= 2) {
        for (int i = 0; i < 200; i++) {
          check(angle + off * (2 * rng.nextDouble() - 1));
        }
      }
    }
  }

  @Test
  void theyHaveTheBitsOfStrictMathWhereTheFormulaChanges() {
    for (int exponent = Double.MIN_EXPONENT - 52; exponent <= Double.MAX_EXPONENT; exponent++) {
      double power = Math.scalb(1.0, exponent);
      check(power);
      check(Math.nextUp(power));
      check(Math.nextDown(power));
    }
    for (double angle :
        new double[] {0.3, 0.78125, 800_000, StrictMath.PI, 0.0, Double.MIN_VALUE}) {
      for (int ulps = -10; ulps <= 10; ulps++) {
        check(angle + ulps * Math.ulp(angle));
      }
      for (long low = 0; low < 10; low++) {
        long high = Double.doubleToRawLongBits(angle) & -1L << Integer.SIZE;
        check(Double.longBitsToDouble(high + low));
        check(Double.longBitsToDouble(high - low - 1));
      }
    }
    check(Double.NaN);
    check(Double.POSITIVE_INFINITY);
    check(Double.MAX_VALUE);
  }

  private static void check(double rad) {
    checkSigned(rad);
    checkSigned(-rad);
  }

  private static void checkSigned(double rad) {
    if (bits(Sines.sin(rad)) != bits(StrictMath.sin(rad))
        || bits(Sines.cos(rad)) != bits(StrictMath.cos(rad))) {
      assertThat(Sines.sin(rad)).as("sine of %s", rad).isEqualTo(StrictMath.sin(rad));
      assertThat(Sines.cos(rad)).as("cosine of %s", rad).isEqualTo(StrictMath.cos(rad));
      throw new AssertionError("other zero or NaN at " + rad);
    }
  }

  private static long bits(double value) {
    return Double.doubleToLongBits(value);
  }
}
