package org.starl.sim.kernel;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * Detects apps that wait where a virtual thread cannot be unmounted: inside a static initialiser or
 * a native method. Such a wait would block the kernel forever, because only the kernel can end it;
 * after the limit this watch makes the wait fail. Has its own thread.
 */
final class PinWatch implements AutoCloseable {

  private static final int LOOKS_PER_LIMIT = 4;

  private final long pauseNs;
  private final Thread thread = new Thread(this::watch, "pinned waits");
  private final AtomicReference<@Nullable VirtualCarrier> resumed = new AtomicReference<>();
  private volatile boolean isClosed;

  PinWatch(Duration limit) {
    pauseNs = Math.max(1, limit.toNanos() / LOOKS_PER_LIMIT);
    thread.setDaemon(true);
    thread.start();
  }

  /** Tells the watch that the kernel runs {@code carrier}'s app now, or no app (null). Cheap. */
  void setResumed(@Nullable VirtualCarrier carrier) {
    resumed.setRelease(carrier);
  }

  @Override
  public void close() {
    isClosed = true;
    LockSupport.unpark(thread);
  }

  private void watch() {
    VirtualCarrier suspect = null;
    long resumes = 0;
    int looks = 0;
    while (!isClosed) {
      LockSupport.parkNanos(this, pauseNs);
      VirtualCarrier carrier = resumed.getAcquire();
      if (carrier == null || !carrier.seemsPinned()) {
        suspect = null;
      } else if (carrier != suspect || carrier.resumes() != resumes) {
        suspect = carrier;
        resumes = carrier.resumes();
        looks = 1;
      } else {
        looks++;
        if (looks > LOOKS_PER_LIMIT) {
          carrier.failPinnedWait();
          suspect = null;
        }
      }
    }
  }
}
