package org.starl.robot.create;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/** A lock with one condition. */
final class Guard {

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();

  /** Runs {@code action} with the lock held. */
  void run(Runnable action) {
    lock.lock();
    try {
      action.run();
    } finally {
      lock.unlock();
    }
  }

  /** Evaluates {@code value} with the lock held. */
  <T> T get(Supplier<T> value) {
    lock.lock();
    try {
      return value.get();
    } finally {
      lock.unlock();
    }
  }

  /** Makes waiting threads check their conditions. Only with the lock held. */
  void signal() {
    changed.signalAll();
  }

  /**
   * Waits until {@code condition} holds, at most {@code ns}.
   *
   * @return whether it holds; false also after an interrupt, which stays set
   */
  boolean await(BooleanSupplier condition, long ns) {
    lock.lock();
    try {
      long leftNs = ns;
      while (!condition.getAsBoolean() && leftNs > 0) {
        leftNs = changed.awaitNanos(leftNs);
      }
      return condition.getAsBoolean();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    } finally {
      lock.unlock();
    }
  }
}
