package org.starl.robot.create;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayDeque;
import org.jspecify.annotations.Nullable;

/** A bounded queue of bytes between a driver, which must not wait, and the thread that writes them. */
final class WriteQueue {

  private final Guard guard = new Guard();
  private final int capacity;
  private final ArrayDeque<Entry> waiting = new ArrayDeque<>();
  private int length;
  private boolean isClosed;

  /** The bytes of one offer. */
  private static final class Entry {
    private final byte[] bytes;
    private final boolean isReplaceable;

    Entry(byte[] bytes, boolean isReplaceable) {
      this.bytes = bytes;
      this.isReplaceable = isReplaceable;
    }
  }

  WriteQueue(int capacity) {
    this.capacity = capacity;
  }

  /** Adds all of {@code bytes}; false if they do not fit (the line is stuck) or it is closed. */
  boolean offer(byte[] bytes) {
    return guard.get(() -> add(new Entry(bytes, false)));
  }

  /**
   * The same, for bytes that a stuck line must not deliver late: they replace those of the last call if
   * these still wait as the newest.
   */
  boolean offerNewest(byte[] bytes) {
    return guard.get(() -> {
      Entry last = waiting.peekLast();
      if (last != null && last.isReplaceable && !isClosed) {
        length -= last.bytes.length;
        waiting.removeLast();
      }
      return add(new Entry(bytes, true));
    });
  }

  private boolean add(Entry entry) {
    if (isClosed || length + entry.bytes.length > capacity) {
      return false;
    }
    waiting.add(entry);
    length += entry.bytes.length;
    guard.signal();
    return true;
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
    try {
      for (byte[] bytes = take(); bytes.length > 0; bytes = take()) {
        output.write(bytes, 0, bytes.length);
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

  /** Waits until there are bytes and takes those of one offer; none once closed and empty. */
  private byte[] take() {
    return guard.get(() -> {
      if (!guard.await(() -> !waiting.isEmpty() || isClosed, Long.MAX_VALUE)) {
        return new byte[0];
      }
      Entry first = waiting.poll();
      length -= first == null ? 0 : first.bytes.length;
      return first == null ? new byte[0] : first.bytes;
    });
  }
}
