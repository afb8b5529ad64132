package org.starl.workload;

import org.starl.sim.Setting;
import org.starl.sim.SimSettings;

/** Times within which things come about on a network that loses and delays as the settings say. */
final class Bounds {

  /** The longest wait between two copies of a message that is repeated until answered. */
  private static final long RESEND_NS = 2_000_000_000;

  /** So improbable that it is not met in any campaign. */
  private static final double NEVER = 1e-9;

  private static final long NS_PER_MS = 1_000_000;

  private Bounds() {}

  /**
   * The paper's delta, in ns: within it a message that is repeated until answered arrives, and its
   * answer as well. One copy may have been lost just before the world became well.
   */
  static long deltaNs(SimSettings settings) {
    double lossOfOne = settings.get(Setting.MESSAGE_LOSS);
    double loss = 1 - (1 - lossOfOne) * (1 - lossOfOne);
    if (loss >= 1) {
      return Long.MAX_VALUE / 1_000_000;
    }
    long copies = 1;
    if (loss > 0) {
      copies += (long) Math.ceil(StrictMath.log(NEVER) / StrictMath.log(loss));
    }
    return settings.messageDelay().longestNs() + copies * RESEND_NS;
  }

  /** Within this time a primitive that takes a few rounds of messages has done what it was asked. */
  static long withinNs(SimSettings settings) {
    return 10 * deltaNs(settings);
  }

  /** A deadline, in ms, that passes after {@code withinNs}: what is late is seen, not told before. */
  static long deadlineMs(long withinNs) {
    return 3 * withinNs / (2 * NS_PER_MS);
  }
}
