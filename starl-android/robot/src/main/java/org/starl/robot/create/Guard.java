package org.starl.robot.create;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** A lock with one condition. All methods may be called from any thread. */
public final class Guard {

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();

  /** Runs {@code action} with the lock held. */
  public void run(Runnable action) {
    lock.lock();
    try {
      action.run();
    } finally {
      lock.unlock();
    }
  }

  /** Evaluates {@code value} with the lock held. */
  public <T extends @Nullable Object> T get(Supplier<T> value) {
    lock.lock();
    try {
      return value.get();
    } finally {
      lock.unlock();
    }
  }

  /** Makes waiting threads check their conditions. Only with the lock held. */
  public void signal() {
    changed.signalAll();
  }

  /**
   * Waits until {@code condition} holds, at most {@code ns}.
   *
   * @return whether it holds; false also after an interrupt, which stays set
   */
  public boolean await(BooleanSupplier condition, long ns) {
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
