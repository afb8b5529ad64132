package org.starl.platform;

import org.starl.random.Rng;

/** The robot's source of randomness: in the simulator the run's seed, forked by stable names. */
public interface Entropy {

  /**
   * A generator of its own for {@code name}; the same name gives the same stream in equal runs,
   * whatever other names are asked for.
   */
  Rng fork(String name);
}
