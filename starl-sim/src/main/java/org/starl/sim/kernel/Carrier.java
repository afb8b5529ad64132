package org.starl.sim.kernel;

/**
 * Carries one app, which waits now and then, beside the kernel, which goes on meanwhile: either the
 * app or the kernel runs, never both.
 */
interface Carrier {

  /**
   * Kernel's side: lets the app begin or go on, and returns when it suspends itself or is over.
   *
   * @throws ForeignWait if it does neither, because it waits for something that is not the kernel,
   *     for longer than the limit
   */
  void resume();

  /** Touches what {@link #resume} is going to use ({@link Cache}). */
  int touch();

  /** App's side: lets the kernel go on, and returns when the kernel resumes it. */
  void suspend();

  /**
   * Kernel's side, after a {@link ForeignWait}: interrupts the app, and returns when it suspends
   * itself or is over.
   *
   * @throws ForeignWait as {@link #resume} does
   */
  void recover();
}
