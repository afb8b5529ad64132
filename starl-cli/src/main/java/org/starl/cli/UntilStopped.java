package org.starl.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Ends work in order when this process is stopped by a signal. */
final class UntilStopped {

  private static final long LIMIT_S = 10;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread hook;

  /**
   * @param stop tells the work to end; called from another thread
   */
  UntilStopped(Runnable stop) {
    hook = new Thread(() -> end(stop), "stopped");
    Runtime.getRuntime().addShutdownHook(hook);
  }

  private void end(Runnable stop) {
    stop.run();
    try {
      if (!ended.await(LIMIT_S, TimeUnit.SECONDS)) {
        Runtime.getRuntime().halt(ExitStatus.VIOLATED);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Call this when the work has ended. */
  void ended() {
    ended.countDown();
  }
}
