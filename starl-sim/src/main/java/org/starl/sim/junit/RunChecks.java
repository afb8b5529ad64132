package org.starl.sim.junit;

import java.util.function.Consumer;
import org.starl.sim.SimResult;

/** Checks of a {@link StarlTest} after a run, besides its monitors. */
@FunctionalInterface
public interface RunChecks {

  /**
   * Checks the result of a good run of this seed: every app has ended, every specification holds.
   * May be called more than once; checks run in order.
   *
   * @param assertion throws if the check fails
   */
  void check(Consumer<SimResult> assertion);
}
