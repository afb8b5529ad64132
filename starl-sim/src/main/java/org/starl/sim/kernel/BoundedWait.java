package org.starl.sim.kernel;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;

/**
 * The kernel's wait for an app that is not back yet, in real time. An interrupt does not end it, and
 * is set again at its end.
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

  /** Gives the one that is waited for the whole limit once more. */
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
