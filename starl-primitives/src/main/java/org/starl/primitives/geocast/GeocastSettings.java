package org.starl.primitives.geocast;

import static org.starl.time.Time.NS_PER_MS;

/**
 * How a geocast repeats itself, and what it may rely on.
 *
 * @param resendMs wait from the first copy to the second, in ms; later waits grow by half
 * @param maxResendMs no wait is longer
 * @param clockSkewNs no two robots' clocks differ by more, ever; delivery stops this long before
 *     the deadline. 0 where the clocks are one, as in a simulation without drift
 * @param openMembership robots beyond the deployment may take part: copies are repeated to the end
 *     even when the whole deployment has acknowledged
 */
public record GeocastSettings(
    long resendMs, long maxResendMs, long clockSkewNs, boolean openMembership) {

  public static final GeocastSettings DEFAULT = new GeocastSettings(100, 1_000, 0, false);

  public GeocastSettings {
    if (resendMs <= 0 || maxResendMs < resendMs || clockSkewNs < 0) {
      throw new IllegalArgumentException(
          "geocast settings: expected waits above 0, the longest not below the first, skew from 0");
    }
  }

  long firstResendNs() {
    return resendMs * NS_PER_MS;
  }

  long nextResendNs(long beforeNs) {
    return Math.min(beforeNs + beforeNs / 2, maxResendMs * NS_PER_MS);
  }
}
