package org.starl.robot.create;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;

/** A bounded queue of bytes between a driver, which must not wait, and the thread that writes them. */
final class WriteQueue {

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final byte[] waiting;
  private int length;
  private boolean isClosed;

  WriteQueue(int capacity) {
    waiting = new byte[capacity];
  }

  /** Adds all of {@code bytes}, or none if they do not fit (the line is stuck) or it is closed. */
  boolean offer(byte[] bytes) {
    lock.lock();
    try {
      if (isClosed || length + bytes.length > waiting.length) {
        return false;
      }
      System.arraycopy(bytes, 0, waiting, length, bytes.length);
      length += bytes.length;
      changed.signal();
      return true;
    } finally {
      lock.unlock();
    }
  }

  /** Takes no more bytes; those that wait are still written. */
  void close() {
    lock.lock();
    try {
      isClosed = true;
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Writes to {@code output} until the queue is closed and empty. If that fails it closes {@code
   * link}, so that the thread that reads from the link finds out and reports it.
   */
  void writeTo(OutputStream output, ByteLink link) {
    byte[] buffer = new byte[waiting.length];
    try {
      for (int n = take(buffer); n > 0; n = take(buffer)) {
        output.write(buffer, 0, n);
        output.flush();
      }
    } catch (IOException e) {
      closeQuietly(link);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      closeQuietly(link);
    }
  }

  /** Closes a link or a server that nothing uses any more; a failure to close it has no effect. */
  static void closeQuietly(@Nullable Closeable closeable) {
    if (closeable != null) {
      try {
        closeable.close();
      } catch (IOException ignored) {
        return;
      }
    }
  }

  /** Waits until there are bytes and moves them into {@code into}; 0 once closed and empty. */
  private int take(byte[] into) throws InterruptedException {
    lock.lock();
    try {
      while (length == 0 && !isClosed) {
        changed.await();
      }
      int count = length;
      System.arraycopy(waiting, 0, into, 0, count);
      length = 0;
      return count;
    } finally {
      lock.unlock();
    }
  }
}
