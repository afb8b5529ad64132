package org.starl.sim.net;

/**
 * Makes the choice that the air has about a copy which no rule decided: lost, or how late. A seed, a
 * recorded schedule or an explorer can stand behind it.
 */
@FunctionalInterface
public interface LinkChoice {

  /** The answer that says lost. */
  long LOST = -1;

  /** The delay of {@code copy} in ns, at least 0, or {@link #LOST}. */
  long delayNsOrLost(Transmission copy, Latency latency, Loss loss);

  /** The choice that a seeded run makes: draws from the copy's own generator. */
  static LinkChoice seeded() {
    return (copy, latency, loss) -> loss.strikes(copy.rng()) ? LOST : latency.drawNs(copy.rng());
  }
}
