package org.starl.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Lets work end in order when this process is stopped from outside. */
final class UntilStopped {

  private static final long LIMIT_S = 10;

  private final CountDownLatch ended = new CountDownLatch(1);
  private final Thread hook;

  /** @param stop makes the work end soon; called from another thread */
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

  /** The work has ended. */
  void ended() {
    ended.countDown();
  }
}
