package org.starl.sim;

/**
 * Somebody who stands beside a run: looks on before its first step and after each one, may let it wait,
 * and may intervene. Called on the thread of the run, while no robot's program runs. A step is one event
 * of the kernel. Where there is a bystander who does nothing, the run is the same as without.
 */
@FunctionalInterface
public interface Bystander {

  /** Time stands still until it returns. */
  void look(Intervening hands);
}
