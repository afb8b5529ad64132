package org.starl.shape;

import java.math.BigDecimal;
import java.math.RoundingMode;

/**
 * Numbers with a fixed count of decimals, rounded half away from zero. The text depends only on the
 * number's bits, on every JVM and in every locale, and {@code round} is idempotent.
 */
public final class Decimals {

  /** Lengths in mm and speeds in mm/s: micrometres. */
  public static final int MM = 3;

  /** Angles in rad and speeds in rad/s: microradians. */
  public static final int RAD = 6;

  private static final long[] POWERS = {1, 10, 100, 1_000, 10_000, 100_000, 1_000_000};

  // Below this, a scaled number and its half are exact in a double, and its digits fit a long.
  private static final double EXACT = 1e15;

  private Decimals() {}

  /** The number that {@link #append} writes for {@code value}. */
  public static double round(double value, int decimals) {
    double scaled = scaled(value, decimals);
    if (scaled < EXACT) {
      return fromUnits(value < 0 ? -units(scaled) : units(scaled), decimals);
    }
    return huge(value, decimals).doubleValue();
  }

  /**
   * Writes {@code value} with exactly {@code decimals} decimals; zero has no sign.
   *
   * @throws IllegalArgumentException if it is infinite or NaN: no event of a correct run has such a
   *     number
   */
  public static void append(JsonWriter out, double value, int decimals) {
    double scaled = scaled(value, decimals);
    if (scaled >= EXACT) {
      out.ascii(huge(value, decimals).toPlainString());
      return;
    }
    long units = units(scaled);
    if (value < 0 && units > 0) {
      out.ascii('-');
    }
    out.number(units / POWERS[decimals]);
    out.ascii('.');
    long fraction = units % POWERS[decimals];
    for (int digit = decimals - 1; digit >= 0; digit--) {
      out.ascii((char) ('0' + fraction / POWERS[digit] % 10));
    }
  }

  /** {@code units} times 10^-decimals, as the nearest double. */
  static double fromUnits(long units, int decimals) {
    return (double) units / POWERS[decimals];
  }

  private static double scaled(double value, int decimals) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("a number of a trace event is " + value);
    }
    return Math.abs(value) * POWERS[decimals];
  }

  // Adding 0.5 and truncating would round 0.49999999999999994 up to 1.
  private static long units(double scaled) {
    long whole = (long) scaled;
    return scaled - whole >= 0.5 ? whole + 1 : whole;
  }

  private static BigDecimal huge(double value, int decimals) {
    return new BigDecimal(value).setScale(decimals, RoundingMode.HALF_UP);
  }
}
