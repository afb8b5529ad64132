package org.starl.launch;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.starl.robot.realtime.Daemons;

/**
 * Lines for people, printed by a thread of their own: a terminal or a pipe that nothing reads must
 * not block a robot. It stores {@link #MAX_LINES}; it counts further lines, and prints the count as
 * soon as it can. From any thread.
 */
public final class Console implements Consumer<String>, AutoCloseable {

  static final int MAX_LINES = 1000;
  private static final long CLOSE_MS = 2000;
  private static final long POLL_MS = 100;

  private final Consumer<String> out;
  private final BlockingQueue<String> lines = new LinkedBlockingQueue<>(MAX_LINES);
  private final AtomicLong lost = new AtomicLong();
  private volatile boolean isClosed;
  private final Thread thread = Daemons.of("console", this::print);

  /** @param out prints a line; may block */
  public Console(Consumer<String> out) {
    this.out = out;
    thread.start();
  }

  @Override
  public void accept(String line) {
    if (!lines.offer(line)) {
      lost.incrementAndGet();
    }
  }

  /** Prints all lines, but waits no longer than some seconds for a blocked output. */
  @Override
  public void close() {
    isClosed = true;
    Daemons.join(thread, CLOSE_MS);
  }

  /** Whether its output blocks although it was closed. */
  public boolean isStuck() {
    return thread.isAlive();
  }

  private void print() {
    try {
      while (!isClosed || !lines.isEmpty()) {
        String line = lines.poll(POLL_MS, TimeUnit.MILLISECONDS);
        if (line != null) {
          out.accept(line);
        }
        long count = lost.getAndSet(0);
        if (count > 0) {
          out.accept(count + " lines were lost here, because the output was blocked");
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
