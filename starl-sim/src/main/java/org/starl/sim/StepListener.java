package org.starl.sim;

/**
 * Is called before the first step of a run and after each step, and may make the run wait and
 * intervene in it. Called on the thread of the run, while no robot's program runs. A step is one event
 * of the kernel. A bystander that does nothing does not change the run.
 */
@FunctionalInterface
public interface StepListener {

  /** Time stands still until it returns. */
  void onStep(RunController hands);
}
