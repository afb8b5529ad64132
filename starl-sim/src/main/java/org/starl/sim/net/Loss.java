package org.starl.sim.net;

import org.starl.random.Rng;

/**
 * The probability that a datagram is lost: each copy to each recipient independently.
 *
 * @param probability from 0 (never) to 1 (always)
 */
public record Loss(double probability) {

  public static final Loss NONE = new Loss(0);

  public Loss {
    if (!(probability >= 0 && probability <= 1)) {
      throw new IllegalArgumentException("loss " + probability + ": expected from 0 to 1");
    }
  }

  /** Whether to lose a copy. Draws no random number if the probability is 0 or 1. */
  boolean strikes(Rng rng) {
    return probability > 0 && (probability >= 1 || rng.nextBoolean(probability));
  }

  boolean isCertain() {
    return probability == 0 || probability == 1;
  }
}
