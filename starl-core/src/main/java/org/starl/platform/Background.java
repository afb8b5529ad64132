package org.starl.platform;

/**
 * Computes beside the strand what would hold it for too long: a planner that computes on the strand
 * for a second keeps every message and every step of the motion automaton waiting for it.
 */
public interface Background {

  /**
   * Runs {@code task} off the strand, after the tasks submitted before it, and then {@code done} as a
   * piece of the strand, never inside this call. Strand only.
   *
   * <p>On hardware the task runs on another thread while the strand goes on: it must read nothing
   * but immutable values that it was given, and {@code done} sees all that it wrote. In the simulator
   * it runs inside this call, and {@code done} follows after the time that the run's settings say.
   *
   * <p>An exception of the task is a bug: it leaves through the strand, in place of {@code done}. A
   * closed strand hears of nothing.
   */
  void submit(Runnable task, Runnable done);
}
