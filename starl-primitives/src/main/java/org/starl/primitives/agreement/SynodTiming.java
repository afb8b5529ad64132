package org.starl.primitives.agreement;

import static org.starl.time.Time.NS_PER_MS;

import org.starl.random.Rng;

/**
 * Waits of a proposer. Safety does not depend on them.
 *
 * @param resendMs wait for an acceptor's first answer, in ms; about two message delays
 * @param maxResendMs the longest wait for an answer, in ms; waits grow by half each time
 * @param backoffMs mean pause after a first defeat by a higher ballot, in ms; it doubles with each
 *     further defeat
 * @param maxBackoffMs the longest mean pause, in ms
 */
public record SynodTiming(long resendMs, long maxResendMs, long backoffMs, long maxBackoffMs) {

  public static final SynodTiming DEFAULT = new SynodTiming(250, 2_000, 250, 4_000);

  private static final int MAX_DOUBLINGS = 20;

  public SynodTiming {
    if (resendMs <= 0 || maxResendMs < resendMs || backoffMs <= 0 || maxBackoffMs < backoffMs) {
      throw new IllegalArgumentException(
          "synod timing: expected waits above 0, and no bound below its first wait");
    }
  }

  long firstResendNs() {
    return resendMs * NS_PER_MS;
  }

  long nextResendNs(long beforeNs) {
    return Math.min(beforeNs + beforeNs / 2, maxResendMs * NS_PER_MS);
  }

  /** A random pause after {@code defeats} defeats in a row: 0.5 to 1.5 of its mean. */
  long backoffNs(int defeats, Rng rng) {
    long meanMs = Math.min(backoffMs << Math.min(defeats - 1, MAX_DOUBLINGS), maxBackoffMs);
    long halfNs = meanMs * NS_PER_MS / 2;
    return halfNs + rng.nextLong(0, 2 * halfNs);
  }
}
