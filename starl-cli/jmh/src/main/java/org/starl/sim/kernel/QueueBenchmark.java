package org.starl.sim.kernel;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.starl.random.Rng;

/**
 * The event queue in the hold model: it has {@link #events} events, and each operation takes the
 * earliest and adds one, on average 50 ms later.
 */
@State(Scope.Thread)
public class QueueBenchmark {

  private static final double MEAN_DELAY_NS = 50e6;
  private static final int DELAYS = 1 << 16;
  private static final Runnable PIECE = () -> {};

  @Param({"1000", "100000"})
  private int events;

  private final EventQueue queue = new EventQueue();
  private final long[] delaysNs = new long[DELAYS];
  private int next;

  /** Fills the queue. */
  @Setup
  public void fill() {
    Rng rng = new Rng(1);
    for (int i = 0; i < DELAYS; i++) {
      delaysNs[i] = (long) (rng.nextExponential() * MEAN_DELAY_NS);
    }
    for (int i = 0; i < events; i++) {
      queue.add(delayNs(), null, PIECE);
    }
  }

  /** One event less, one more. */
  @Benchmark
  public Runnable hold() {
    queue.poll(Long.MAX_VALUE);
    Runnable piece = queue.piece();
    queue.add(queue.atNs() + delayNs(), null, piece);
    return piece;
  }

  private long delayNs() {
    next = (next + 1) % DELAYS;
    return delaysNs[next];
  }
}
