package org.starl.sim.kernel;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;

/**
 * Bounds the real time that the kernel waits for an app. An interrupt does not end the wait; the
 * interrupt flag is set again at its end.
 */
final class BoundedWait implements AutoCloseable {

  private long startNs = System.nanoTime();
  private final long limitNs;
  private boolean wasInterrupted;

  BoundedWait(Duration limit) {
    this.limitNs = limit.toNanos();
  }

  /**
   * Waits until this thread is unparked; may return early.
   *
   * @return false, at once, if the limit has passed
   */
  boolean park(Object blocker) {
    long restNs = limitNs - (System.nanoTime() - startNs);
    if (restNs <= 0) {
      return false;
    }
    LockSupport.parkNanos(blocker, restNs);
    wasInterrupted |= Thread.interrupted();
    return true;
  }

  /** Restarts the time limit. */
  void restart() {
    startNs = System.nanoTime();
  }

  @Override
  public void close() {
    if (wasInterrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
