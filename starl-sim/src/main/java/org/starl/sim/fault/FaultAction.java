package org.starl.sim.fault;

/** Carries out the effect of a fault. */
@FunctionalInterface
public interface FaultAction {

  /** Begins the fault; the returned action ends it. */
  Runnable begin(FaultContext context);
}
