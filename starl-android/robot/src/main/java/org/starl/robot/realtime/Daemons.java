package org.starl.robot.realtime;

import java.util.concurrent.ThreadFactory;

/** Threads that do not keep the process alive. */
public final class Daemons {

  private Daemons() {}

  /** One that runs {@code body} when it is started. */
  public static Thread of(String name, Runnable body) {
    Thread thread = new Thread(body, name);
    thread.setDaemon(true);
    return thread;
  }

  /** For an executor of one thread. */
  public static ThreadFactory factory(String name) {
    return body -> of(name, body);
  }

  /**
   * Waits until a thread that was told to end has ended; returns at once on that thread itself, and
   * when interrupted.
   *
   * @param limitMs at most so long; 0 for no limit
   */
  public static void join(Thread thread, long limitMs) {
    if (Thread.currentThread() == thread) {
      return;
    }
    try {
      thread.join(limitMs);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
