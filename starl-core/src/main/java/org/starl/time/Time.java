package org.starl.time;

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
    long unit = NS_PER_S;
    for (int i = 0; i < decimals; i++) {
      unit /= 10;
    }
    long size = Math.abs(ns);
    long units = size / unit + (size % unit * 2 >= unit ? 1 : 0);
    StringBuilder text = new StringBuilder().append(units);
    while (text.length() <= decimals) {
      text.insert(0, '0');
    }
    if (decimals > 0) {
      text.insert(text.length() - decimals, '.');
    }
    return (ns < 0 && units > 0 ? "-" : "") + text + " s";
  }

  /** The time {@code ms} after {@code nowNs}; {@code Long.MAX_VALUE} (never) if that overflows. */
  public static long afterMs(long nowNs, long ms) {
    return ms > (Long.MAX_VALUE - nowNs) / NS_PER_MS ? Long.MAX_VALUE : nowNs + ms * NS_PER_MS;
  }
}
