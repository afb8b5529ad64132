package org.starl.sim.kernel;

/**
 * The thread of one blocking app. Either the app or the kernel runs, never both: while the app waits,
 * the kernel continues.
 */
interface Carrier {

  /**
   * Called by the kernel: starts or resumes the app, and returns when it suspends itself or ends.
   *
   * @throws NonKernelWait if the app blocks outside the kernel for longer than the limit
   */
  void resume();

  /** The thread on which the app runs. */
  Thread thread();

  /** Prefetches the objects that {@link #resume} will use ({@link Cache}). */
  int touch();

  /** Called by the app: resumes the kernel, and returns when the kernel resumes the app. */
  void suspend();

  /**
   * Called by the kernel after a {@link NonKernelWait}: interrupts the app, and returns when the
   * app suspends itself or ends.
   *
   * @throws NonKernelWait as {@link #resume} does
   */
  void recover();
}
