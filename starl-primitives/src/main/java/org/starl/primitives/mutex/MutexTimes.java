package org.starl.primitives.mutex;

/**
 * When a waiting process repeats itself, and when it gives up. Safety depends on none of it.
 *
 * @param resendMs from a request to its first repetition to those who have not answered
 * @param backoff factor from one such wait to the next, at least 1
 * @param maxResendMs no such wait is longer
 * @param deadlineMs a request that has no access after this time fails
 */
public record MutexTimes(long resendMs, double backoff, long maxResendMs, long deadlineMs) {

  public static final MutexTimes DEFAULT = new MutexTimes(250, 1.5, 1_000, 600_000);

  /** A century: beyond it, sums of ns would overflow. */
  private static final long MAX_MS = 100L * 366 * 24 * 3600 * 1000;

  public MutexTimes {
    if (resendMs <= 0
        || !(backoff >= 1)
        || maxResendMs < resendMs
        || maxResendMs > MAX_MS
        || deadlineMs <= 0
        || deadlineMs > MAX_MS) {
      throw new IllegalArgumentException(
          "mutex times: expected 0 < resendMs <= maxResendMs, backoff at least 1, 0 < deadlineMs");
    }
  }

  /** The same with another deadline. */
  public MutexTimes withDeadlineMs(long otherMs) {
    return new MutexTimes(resendMs, backoff, maxResendMs, otherMs);
  }
}
