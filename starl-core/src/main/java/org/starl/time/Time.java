package org.starl.time;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Units of time. Times and durations are {@code long} nanoseconds; settings are milliseconds. */
public final class Time {

  public static final long NS_PER_MS = 1_000_000;
  public static final long NS_PER_S = 1_000_000_000;

  private Time() {}

  /** {@code ns} in seconds. */
  public static double seconds(long ns) {
    return ns / 1e9;
  }

  /** {@code ns} in milliseconds. */
  public static double ms(long ns) {
    return ns / 1e6;
  }

  /** {@code ns} in seconds with {@code decimals} decimals, from 0 to 9, for people: {@code 12.3 s}. */
  public static String text(long ns, int decimals) {
    return BigDecimal.valueOf(ns, 9).setScale(decimals, RoundingMode.HALF_UP).toPlainString()
        + " s";
  }
}
