package org.starl.android.app;

import java.util.ArrayDeque;
import java.util.Deque;

/** What was opened so far, to be closed again, the last first, if the rest cannot be opened. */
final class Closer {

  private final Deque<AutoCloseable> opened = new ArrayDeque<>();

  <T extends AutoCloseable> T add(T closeable) {
    opened.push(closeable);
    return closeable;
  }

  void close() {
    for (AutoCloseable each : opened) {
      try {
        each.close();
      } catch (Exception e) {
        throw new IllegalStateException(each + " cannot be closed", e);
      }
    }
    opened.clear();
  }
}
