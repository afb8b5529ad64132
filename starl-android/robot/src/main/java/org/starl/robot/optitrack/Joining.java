package org.starl.robot.optitrack;

/** Waits for a thread of this package that has been told to end. */
final class Joining {

  private Joining() {}

  /** Returns when it has ended; at once on that thread itself, or when interrupted. */
  static void join(Thread thread) {
    if (Thread.currentThread() == thread) {
      return;
    }
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
