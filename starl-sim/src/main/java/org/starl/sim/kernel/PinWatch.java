package org.starl.sim.kernel;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * Watches for apps that wait where a virtual thread cannot leave the kernel's thread: inside a
 * static initialiser or a native method. Such a wait would hold the kernel for good, since only the
 * kernel could end it; past the limit this watch makes it fail. Has a thread of its own.
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

  /** The kernel runs {@code carrier}'s app now, or itself again (null). Cheap. */
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
