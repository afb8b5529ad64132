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
}
