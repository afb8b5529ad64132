package org.starl.primitives.geocast;

import static org.starl.time.Time.NS_PER_MS;

/**
 * The settings of a geocast.
 *
 * @param resendMs the wait from the first copy to the second; later waits grow by half
 * @param maxResendMs the longest wait
 * @param clockSkewNs the largest difference between two robots' clocks; delivery stops this long
 *     before the deadline. 0 for equal clocks, as in a simulation without drift
 * @param openMembership whether robots outside the deployment may take part: then copies are
 *     repeated to the end even if the whole deployment has acknowledged
 */
public record GeocastSettings(
    long resendMs, long maxResendMs, long clockSkewNs, boolean openMembership) {

  public static final GeocastSettings DEFAULT = new GeocastSettings(100, 1_000, 0, false);

  public GeocastSettings {
    if (resendMs <= 0 || maxResendMs < resendMs || clockSkewNs < 0) {
      throw new IllegalArgumentException(
          "geocast settings: expected 0 < resendMs <= maxResendMs and clockSkewNs >= 0");
    }
  }

  /**
   * In a network without loss a copy reaches every robot in any time of this length, in ns: the longest
   * wait for a repetition, and its delay.
   */
  long reachNs(long longestDelayNs) {
    return maxResendMs * NS_PER_MS + longestDelayNs;
  }

  /** The same settings with another difference between clocks, in ns. */
  public GeocastSettings withClockSkewNs(long skewNs) {
    return new GeocastSettings(resendMs, maxResendMs, skewNs, openMembership);
  }

  long firstResendNs() {
    return resendMs * NS_PER_MS;
  }

  long nextResendNs(long beforeNs) {
    return Math.min(beforeNs + beforeNs / 2, maxResendMs * NS_PER_MS);
  }
}
