package org.starl.robot.create;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import org.jspecify.annotations.Nullable;

/** A bounded queue of bytes between a driver, which must not wait, and the thread that writes them. */
final class WriteQueue {

  private final Guard guard = new Guard();
  private final byte[] waiting;
  private int length;
  private boolean isClosed;

  WriteQueue(int capacity) {
    waiting = new byte[capacity];
  }

  /** Adds all of {@code bytes}; false if they do not fit (the line is stuck) or it is closed. */
  boolean offer(byte[] bytes) {
    return guard.get(() -> {
      if (isClosed || length + bytes.length > waiting.length) {
        return false;
      }
      System.arraycopy(bytes, 0, waiting, length, bytes.length);
      length += bytes.length;
      guard.signal();
      return true;
    });
  }

  /** Refuses further bytes; waiting bytes are still written. */
  void close() {
    guard.run(() -> {
      isClosed = true;
      guard.signal();
    });
  }

  /**
   * Writes to {@code output} until the queue is closed and empty. If that fails it closes {@code
   * link}, so that the thread that reads from the link notices and reports the failure.
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
    }
    if (Thread.currentThread().isInterrupted()) {
      closeQuietly(link);
    }
  }

  /** Closes a link or a server that is no longer used; a failure to close it has no effect. */
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
  private int take(byte[] into) {
    return guard.get(() -> {
      if (!guard.await(() -> length > 0 || isClosed, Long.MAX_VALUE)) {
        return 0;
      }
      int count = length;
      System.arraycopy(waiting, 0, into, 0, count);
      length = 0;
      return count;
    });
  }
}
