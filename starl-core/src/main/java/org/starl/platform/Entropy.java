package org.starl.platform;

import org.starl.random.Rng;

/**
 * The robot's random generators. In the simulator they derive from the run's seed and stable names.
 */
public interface Entropy {

  /**
   * An independent generator for {@code name}. In runs with equal seeds, equal names give equal
   * streams, whichever other names are used.
   */
  Rng fork(String name);
}
