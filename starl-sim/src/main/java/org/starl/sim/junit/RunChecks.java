package org.starl.sim.junit;

import java.util.function.Consumer;
import org.starl.sim.SimResult;

/** Checks of a {@link StarlTest} after a run, besides its monitors. */
@FunctionalInterface
public interface RunChecks {

  /**
   * Checks the result of this seed's run if that went well: every app ended, every specification
   * held. May be called more than once; checks run in that order.
   *
   * @param assertion throws if it does not hold
   */
  void check(Consumer<SimResult> assertion);
}
