package org.starl.sim.net;

/**
 * Chooses loss or delay for a copy that no rule decided. The implementation can draw by seed, follow
 * a recorded schedule, or explore.
 */
@FunctionalInterface
public interface LinkChoice {

  /** The answer for a lost copy. */
  long LOST = -1;

  /** The delay of {@code copy} in ns, at least 0, or {@link #LOST}. */
  long delayNsOrLost(Transmission copy, Latency latency, Loss loss);

  /** The choice by seed: draws from the copy's own generator. */
  static LinkChoice seeded() {
    return (copy, latency, loss) -> loss.strikes(copy.rng()) ? LOST : latency.drawNs(copy.rng());
  }
}
