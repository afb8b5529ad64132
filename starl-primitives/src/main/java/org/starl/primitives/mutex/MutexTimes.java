package org.starl.primitives.mutex;

/**
 * The timeouts of a waiting request. Safety does not depend on them.
 *
 * @param resendMs the wait before the first repetition to participants that have not answered
 * @param backoff the factor from one wait to the next, at least 1
 * @param maxResendMs the longest wait
 * @param deadlineMs the time after which a request without access fails
 * @param suspectMs the time after which a silent participant is suspected of a crash; many times
 *     {@code maxResendMs}, because a wrongly suspected participant must register again
 * @param occupiedMs the least time after which a request fails that waits only for a ghost; it
 *     would delay the requests behind it, perhaps one of the ghost's own robot
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

  /** The same times with another deadline. */
  public MutexTimes withDeadlineMs(long otherMs) {
    return new MutexTimes(resendMs, backoff, maxResendMs, otherMs, suspectMs, occupiedMs);
  }

  /** The same times with another time until suspicion. */
  public MutexTimes withSuspectMs(long otherMs) {
    return new MutexTimes(resendMs, backoff, maxResendMs, deadlineMs, otherMs, occupiedMs);
  }
}
