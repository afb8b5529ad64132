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
  private static final long CLOSE_S = 2;
  private static final String END = new String("end");

  private final Consumer<String> out;
  private final BlockingQueue<String> lines = new LinkedBlockingQueue<>(MAX_LINES);
  private final AtomicLong lost = new AtomicLong();
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
    try {
      if (lines.offer(END, CLOSE_S, TimeUnit.SECONDS)) {
        Daemons.join(thread, TimeUnit.SECONDS.toMillis(CLOSE_S));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether its output blocks although it was closed. */
  public boolean isStuck() {
    return thread.isAlive();
  }

  @SuppressWarnings("ReferenceEquality") // END is this object; a program's empty line is a line
  private void print() {
    try {
      for (String line = lines.take(); line != END; line = lines.take()) {
        out.accept(line);
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
