package org.starl.robot.realtime;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.starl.platform.Background;
import org.starl.platform.Strand;

/**
 * Computes on one worker thread, a daemon, and posts what is done to the strand. The
 * strand goes on meanwhile.
 */
public final class RealBackground implements Background, AutoCloseable {

  private final Strand strand;
  private final BlockingQueue<Task> tasks = new LinkedBlockingQueue<>();
  private final Thread worker;

  private record Task(Runnable task, Runnable done) {}

  /**
   * A worker that runs from now on.
   *
   * @param name of the robot; the thread bears it
   */
  public RealBackground(String name, Strand strand) {
    this.strand = strand;
    worker = new Thread(this::loop, name + " background");
    worker.setDaemon(true);
    worker.start();
  }

  @Override
  public void submit(Runnable task, Runnable done) {
    tasks.add(new Task(task, done));
  }

  /** Begins no further task; the one that runs is interrupted, and its strand hears of it no more. */
  @Override
  public void close() {
    worker.interrupt();
  }

  private void loop() {
    try {
      while (!worker.isInterrupted()) {
        Task next = tasks.take();
        Runnable outcome = compute(next);
        if (!worker.isInterrupted()) {
          strand.post(outcome);
        }
      }
    } catch (InterruptedException e) {
      // Only close() interrupts: the worker ends, and says so to nobody.
      Thread.currentThread().interrupt();
    }
  }

  private static Runnable compute(Task task) {
    try {
      task.task().run();
      return task.done();
    } catch (RuntimeException | Error e) {
      return () -> {
        throw e;
      };
    }
  }
}
