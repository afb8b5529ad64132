package org.starl.robot.create;

import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** Bytes that wait for the thread that writes them; never more than its capacity. */
final class Outbox {

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final byte[] waiting;
  private int length;
  private boolean isClosed;
  private long refused;

  Outbox(int capacity) {
    waiting = new byte[capacity];
  }

  /** Adds all of {@code bytes}, or none of them where they do not fit: the line is stuck. */
  boolean offer(byte[] bytes, int count) {
    lock.lock();
    try {
      if (isClosed || length + count > waiting.length) {
        refused += count;
        return false;
      }
      System.arraycopy(bytes, 0, waiting, length, count);
      length += count;
      changed.signal();
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Waits until there are bytes, moves them into {@code into}; -1 once closed and empty. */
  int take(byte[] into) throws InterruptedException {
    lock.lock();
    try {
      while (length == 0 && !isClosed) {
        changed.await();
      }
      int count = Math.min(length, into.length);
      System.arraycopy(waiting, 0, into, 0, count);
      System.arraycopy(waiting, count, waiting, 0, length - count);
      length -= count;
      return count == 0 ? -1 : count;
    } finally {
      lock.unlock();
    }
  }

  /** Takes no more; what waits may still be taken. */
  void close() {
    lock.lock();
    try {
      isClosed = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** Bytes that did not fit. */
  long refused() {
    lock.lock();
    try {
      return refused;
    } finally {
      lock.unlock();
    }
  }
}
