package org.starl.primitives.paths;

/**
 * How a {@link DistributedPathPlanning} goes about it.
 *
 * @param positionErrorMm while it drives along its tube a robot knows its position to within this;
 *     where it does not, it stands and waits
 * @param maxLegMm no part of a tube is longer; shorter ones are given back sooner
 * @param deadlineMs what is not under way by then has failed
 * @param resendMs wait for a first answer, about two message delays
 * @param maxResendMs no wait for an answer is longer; waits grow by half each time
 * @param pauseMs mean pause after a first refusal; it doubles with each further one
 * @param maxPauseMs no mean pause is longer
 */
public record TubeSettings(
    int positionErrorMm,
    int maxLegMm,
    long deadlineMs,
    long resendMs,
    long maxResendMs,
    long pauseMs,
    long maxPauseMs) {

  public static final TubeSettings DEFAULT =
      new TubeSettings(60, 1_000, 60_000, 200, 2_000, 200, 2_000);

  private static final long NS_PER_MS = 1_000_000;

  public TubeSettings {
    boolean valid =
        positionErrorMm >= 0
            && maxLegMm > 0
            && deadlineMs > 0
            && resendMs > 0
            && maxResendMs >= resendMs
            && pauseMs > 0
            && maxPauseMs >= pauseMs;
    if (!valid) {
      throw new IllegalArgumentException(
          "tube settings: expected times above 0, and no bound below its first wait");
    }
  }

  long deadlineNs() {
    return deadlineMs * NS_PER_MS;
  }

  long resendNs() {
    return resendMs * NS_PER_MS;
  }

  long maxResendNs() {
    return maxResendMs * NS_PER_MS;
  }

  /** The mean pause after the {@code refusals}-th refusal in a row. */
  long pauseNs(int refusals) {
    long pauseNs = pauseMs * NS_PER_MS;
    for (int i = 1; i < refusals && pauseNs < maxPauseMs * NS_PER_MS; i++) {
      pauseNs *= 2;
    }
    return Math.min(pauseNs, maxPauseMs * NS_PER_MS);
  }
}
