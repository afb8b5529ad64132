package org.starl.platform;

/**
 * Runs long computations off the strand. A planner that computed on the strand for one second would
 * delay every message and every step of the motion automaton by that time.
 */
public interface Background {

  /**
   * Runs {@code task} off the strand, after all tasks submitted before it, and then {@code done} on
   * the strand, never inside this call. Strand only.
   *
   * <p>On hardware the task runs on another thread while the strand continues: it may read only
   * immutable values that it was given; {@code done} sees everything that it wrote. In the
   * simulator it runs inside this call, and {@code done} runs after the compute time of the run's
   * settings.
   *
   * <p>An exception in the task is a bug: it propagates through the strand instead of {@code done}.
   * Nothing runs on a closed strand.
   */
  void submit(Runnable task, Runnable done);
}
