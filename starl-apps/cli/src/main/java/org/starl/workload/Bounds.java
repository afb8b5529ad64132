package org.starl.workload;

import org.starl.sim.Setting;
import org.starl.sim.SimSettings;

/** Time bounds for the network's loss and delay in the settings. */
final class Bounds {

  /** Maximum time between two copies of a message that is repeated until answered. */
  private static final long RESEND_NS = 2_000_000_000;

  /** A probability so small that no campaign meets it. */
  private static final double NEVER = 1e-9;

  private static final long NS_PER_MS = 1_000_000;

  private Bounds() {}

  /**
   * The paper's delta, in ns: the time within which a message that is repeated until answered, and its
   * answer, arrive. One copy may have been lost just before the faults ended.
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

  /** Time within which a primitive that needs a few rounds of messages has answered. */
  static long withinNs(SimSettings settings) {
    return 10 * deltaNs(settings);
  }

  /** A deadline, in ms, after {@code withinNs}: a late answer violates the specification first. */
  static long deadlineMs(long withinNs) {
    return 3 * withinNs / (2 * NS_PER_MS);
  }
}
