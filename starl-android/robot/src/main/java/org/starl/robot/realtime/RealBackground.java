package org.starl.robot.realtime;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.starl.platform.Background;
import org.starl.platform.Strand;

/** Computes on one daemon thread beside the strand, and posts each result to the strand. */
public final class RealBackground implements Background, AutoCloseable {

  private final Strand strand;
  private final ExecutorService worker;

  /** @param name of the robot, for the thread's name */
  public RealBackground(String name, Strand strand) {
    this.strand = strand;
    worker =
        new ThreadPoolExecutor(
            1,
            1,
            0,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            Daemons.factory(name + " background"),
            new ThreadPoolExecutor.DiscardPolicy());
  }

  @Override
  public void submit(Runnable task, Runnable done) {
    worker.execute(() -> {
      Runnable outcome = compute(task, done);
      if (!worker.isShutdown()) {
        strand.post(outcome);
      }
    });
  }

  /** Starts no further task, interrupts the running one, and posts no more results. */
  @Override
  public void close() {
    worker.shutdownNow();
  }

  private static Runnable compute(Runnable task, Runnable done) {
    try {
      task.run();
      return done;
    } catch (RuntimeException | Error e) {
      return () -> {
        throw e;
      };
    }
  }
}
