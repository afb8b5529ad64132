package org.starl.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Ends work in order when this process is stopped by a signal: Ctrl-C, SIGTERM. The exit status is
 * then the JVM's, 130 or 143.
 */
final class UntilStopped {

  private static final long LIMIT_S = 10;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread hook;
  private volatile boolean isStopped;

  /**
   * @param stop tells the work to end; called from another thread
   */
  UntilStopped(Runnable stop) {
    hook = new Thread(() -> end(stop), "stopped");
    Runtime.getRuntime().addShutdownHook(hook);
  }

  /** Interrupts the calling thread. */
  static UntilStopped interrupting() {
    return new UntilStopped(Thread.currentThread()::interrupt);
  }

  private void end(Runnable stop) {
    if (ended.getCount() == 0) {
      return;
    }
    isStopped = true;
    stop.run();
    try {
      if (!ended.await(LIMIT_S, TimeUnit.SECONDS)) {
        Runtime.getRuntime().halt(ExitStatus.VIOLATED);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether a signal has come before the work ended. */
  boolean isStopped() {
    return isStopped;
  }

  /** Call this when the work has ended, and all is printed. */
  void ended() {
    ended.countDown();
  }
}
