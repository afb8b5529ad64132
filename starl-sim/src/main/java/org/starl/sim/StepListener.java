package org.starl.sim;

/**
 * Called before the first step of a run and after each step; may pause the run and intervene.
 * Called on the thread of the run, while no robot's program runs. A step is one event of the
 * kernel. A listener without interventions does not change the run.
 */
@FunctionalInterface
public interface StepListener {

  /** Simulated time does not advance until this method returns. */
  void onStep(RunController controller);
}
