package org.starl.primitives.paths;

import static org.starl.time.Time.NS_PER_MS;

import org.starl.platform.StartNeeds;

/**
 * The settings of a {@link DistributedPathPlanning}.
 *
 * @param positionErrorMm the largest position error in a tube; with a larger one the robot waits
 * @param maxLegMm the largest length of a tube's part; shorter parts are released sooner
 * @param deadlineMs a {@code goTo} that is not moving after this time fails
 * @param resendMs the first wait for an answer, about two message delays; it grows by half each
 *     time
 * @param maxResendMs the longest wait for an answer
 * @param pauseMs the mean pause after the first refusal; it doubles with each further one
 * @param maxPauseMs the longest mean pause
 */
public record TubeSettings(
    int positionErrorMm,
    int maxLegMm,
    long deadlineMs,
    long resendMs,
    long maxResendMs,
    long pauseMs,
    long maxPauseMs) {

  /** Planners find a path for a margin that is larger by half a per cent and 4 mm. */
  private static final double FREE = 1.005;

  public static final TubeSettings DEFAULT =
      new TubeSettings(60, 1_000, 60_000, 200, 2_000, 200, 2_000);

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
          "tube settings: expected lengths and times above 0, and no maximum below its first wait");
    }
  }

  /** The discs of two robots at their starts must not touch; the rounding of two centres included. */
  StartNeeds needs(int radiusMm) {
    return new StartNeeds(
        "reach tubes", 2 * radiusMm + 2, FREE * radiusMm + 4, positionErrorMm, deadlineNs());
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
