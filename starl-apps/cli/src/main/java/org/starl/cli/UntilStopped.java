package org.starl.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Stops something when somebody stops this process, and lets it come to its end. */
final class UntilStopped {

  private static final long LIMIT_S = 10;

  private final CountDownLatch over = new CountDownLatch(1);
  private final Thread hook;

  UntilStopped(Runnable stop) {
    hook = new Thread(() -> end(stop), "stopped");
    Runtime.getRuntime().addShutdownHook(hook);
  }

  private void end(Runnable stop) {
    stop.run();
    try {
      if (!over.await(LIMIT_S, TimeUnit.SECONDS)) {
        Runtime.getRuntime().halt(ExitStatus.VIOLATED);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** It has come to its end. */
  void over() {
    over.countDown();
  }
}
