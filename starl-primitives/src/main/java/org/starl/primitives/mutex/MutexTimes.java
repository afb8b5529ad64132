package org.starl.primitives.mutex;

/**
 * When a waiting process repeats itself, whom it suspects, and when it gives up. Safety depends on
 * none of it.
 *
 * @param resendMs from a request to its first repetition to those who have not answered
 * @param backoff factor from one such wait to the next, at least 1
 * @param maxResendMs no such wait is longer
 * @param deadlineMs a request that has no access after this time fails
 * @param suspectMs who is asked and says nothing for so long is taken for crashed; many times
 *     {@code maxResendMs}, since the price of a wrong suspicion is that the other must register
 *     anew
 * @param occupiedMs a request that everybody has granted and only a ghost stands in the way of
 *     fails after this time at the earliest: it would keep back who waits behind it, maybe the very
 *     robot whose ghost it is
 */
public record MutexTimes(
    long resendMs,
    double backoff,
    long maxResendMs,
    long deadlineMs,
    long suspectMs,
    long occupiedMs) {

  public static final MutexTimes DEFAULT = new MutexTimes(250, 1.5, 1_000, 600_000, 10_000, 1_000);

  /** A century: beyond it, sums of ns would overflow. */
  private static final long MAX_MS = 100L * 366 * 24 * 3600 * 1000;

  public MutexTimes {
    if (resendMs <= 0
        || !(backoff >= 1)
        || maxResendMs < resendMs
        || maxResendMs > MAX_MS
        || deadlineMs <= 0
        || deadlineMs > MAX_MS
        || suspectMs <= 0
        || suspectMs > MAX_MS
        || occupiedMs <= 0
        || occupiedMs > MAX_MS) {
      throw new IllegalArgumentException(
          "mutex times: expected 0 < resendMs <= maxResendMs, backoff at least 1, others above 0");
    }
  }

  /** The same with another deadline. */
  public MutexTimes withDeadlineMs(long otherMs) {
    return new MutexTimes(resendMs, backoff, maxResendMs, otherMs, suspectMs, occupiedMs);
  }

  /** The same with another time until suspicion. */
  public MutexTimes withSuspectMs(long otherMs) {
    return new MutexTimes(resendMs, backoff, maxResendMs, deadlineMs, otherMs, occupiedMs);
  }
}
