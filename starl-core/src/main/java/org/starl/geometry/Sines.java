package org.starl.geometry;

/**
 * Sine and cosine with the bits of {@code StrictMath}, which allocates two arrays for each angle
 * beyond an eighth of a turn. The same algorithm without them, for angles up to {@value #MOST_FAST};
 * for others it calls {@code StrictMath}.
 *
 * <p>The formulas are those of fdlibm 5.3, which the specification of {@code StrictMath} demands:
 *
 * <pre>
 * Copyright (C) 1993 by Sun Microsystems, Inc. All rights reserved.
 *
 * Developed at SunSoft, a Sun Microsystems, Inc. business.
 * Permission to use, copy, modify, and distribute this
 * software is freely granted, provided that this notice
 * is preserved.
 * </pre>
 */
public final class Sines {

  private static final double MOST_FAST = 800_000;

  // Upper halves of the bits of a double, without its sign.
  private static final int MAGNITUDE = 0x7fffffff;
  private static final int TINY = 0x3e400000;
  private static final int EIGHTH_OF_A_TURN = 0x3fe921fb;
  private static final int SMALL = 0x3fd33333;
  private static final int LARGE = 0x3fe90000;
  private static final int QUARTER = 0x00200000;

  private static final int FEW_QUARTERS = 32;
  private static final int EXPONENT_SHIFT = 20;

  // A quarter turn as the sum of three parts of 33 bits; after each, all that is left.
  private static final double QUARTERS_A_RADIAN = 0x1.45f306dc9c883p-1;
  private static final double FIRST = 0x1.921fb544p0;
  private static final double AFTER_FIRST = 0x1.0b4611a626331p-34;
  private static final double SECOND = 0x1.0b4611a6p-34;
  private static final double AFTER_SECOND = 0x1.3198a2e037073p-69;
  private static final double THIRD = 0x1.3198a2ep-69;
  private static final double AFTER_THIRD = 0x1.b839a252049c1p-104;

  private static final double S1 = -0x1.5555555555549p-3;
  private static final double S2 = 0x1.111111110f8a6p-7;
  private static final double S3 = -0x1.a01a019c161d5p-13;
  private static final double S4 = 0x1.71de357b1fe7dp-19;
  private static final double S5 = -0x1.ae5e68a2b9cebp-26;
  private static final double S6 = 0x1.5d93a5acfd57cp-33;

  private static final double C1 = 0x1.555555555554cp-5;
  private static final double C2 = -0x1.6c16c16c15177p-10;
  private static final double C3 = 0x1.a01a019cb159p-16;
  private static final double C4 = -0x1.27e4f809c52adp-22;
  private static final double C5 = 0x1.1ee9ebdb4b1c4p-29;
  private static final double C6 = -0x1.8fae9be8838d4p-37;

  private Sines() {}

  /** The bits of {@code StrictMath.sin}. */
  public static double sin(double rad) {
    if (high(rad) <= EIGHTH_OF_A_TURN) {
      return sinOfSmall(rad);
    }
    return Math.abs(rad) <= MOST_FAST ? reduced(rad, 0) : StrictMath.sin(rad);
  }

  /** The bits of {@code StrictMath.cos}. */
  public static double cos(double rad) {
    if (high(rad) <= EIGHTH_OF_A_TURN) {
      return cosOfSmall(rad, 0);
    }
    return Math.abs(rad) <= MOST_FAST ? reduced(rad, 1) : StrictMath.cos(rad);
  }

  /** The sine of {@code rad} plus so many quarter turns. */
  private static double reduced(double rad, int more) {
    double angle = Math.abs(rad);
    int quarters = (int) (angle * QUARTERS_A_RADIAN + 0.5);
    double left = angle - quarters * FIRST;
    double tail = quarters * AFTER_FIRST;
    double rest = left - tail;
    // Near a multiple of a quarter turn, leading bits cancel out: more parts are needed.
    int exponent = exponent(angle);
    boolean mayBeNear =
        quarters >= FEW_QUARTERS || high(angle) == high(quarters * (StrictMath.PI / 2));
    if (mayBeNear && exponent - exponent(rest) > 16) {
      double before = left;
      tail = quarters * SECOND;
      left = before - tail;
      tail = quarters * AFTER_SECOND - ((before - left) - tail);
      rest = left - tail;
      if (exponent - exponent(rest) > 49) {
        before = left;
        tail = quarters * THIRD;
        left = before - tail;
        tail = quarters * AFTER_THIRD - ((before - left) - tail);
        rest = left - tail;
      }
    }
    double low = (left - rest) - tail;
    return rad < 0 ? sinOf(-rest, -low, more - quarters) : sinOf(rest, low, more + quarters);
  }

  private static double sinOf(double rest, double low, int quarters) {
    return switch (quarters & 3) {
      case 0 -> sinOfSmall(rest, low);
      case 1 -> cosOfSmall(rest, low);
      case 2 -> -sinOfSmall(rest, low);
      default -> -cosOfSmall(rest, low);
    };
  }

  private static double sinOfSmall(double x) {
    if (high(x) < TINY) {
      return x;
    }
    double z = x * x;
    return x + z * x * (S1 + z * sinSeries(z));
  }

  private static double sinOfSmall(double x, double low) {
    if (high(x) < TINY) {
      return x;
    }
    double z = x * x;
    double v = z * x;
    return x - ((z * (0.5 * low - v * sinSeries(z)) - low) - v * S1);
  }

  private static double sinSeries(double z) {
    return S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
  }

  private static double cosOfSmall(double x, double low) {
    int high = high(x);
    if (high < TINY) {
      return 1;
    }
    double z = x * x;
    double r = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
    if (high < SMALL) {
      return 1 - (0.5 * z - (z * r - x * low));
    }
    double part =
        high > LARGE ? 0.28125 : Double.longBitsToDouble((long) (high - QUARTER) << Integer.SIZE);
    return (1 - part) - ((0.5 * z - part) - (z * r - x * low));
  }

  private static int high(double x) {
    return (int) (Double.doubleToRawLongBits(x) >> Integer.SIZE) & MAGNITUDE;
  }

  private static int exponent(double x) {
    return high(x) >> EXPONENT_SHIFT;
  }
}
