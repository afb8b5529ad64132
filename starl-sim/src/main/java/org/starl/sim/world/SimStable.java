package org.starl.sim.world;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.platform.Clock;
import org.starl.platform.StableStorage;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/**
 * A robot's stable storage in memory. It outlives the robot's program: {@link #restart} passes the
 * flushed values, and no others, to the next incarnation.
 */
public final class SimStable implements StableStorage {

  private final Clock clock;
  private final Map<String, byte[]> flushed = new TreeMap<>();
  private final Deque<Write> pending = new ArrayDeque<>(2);
  private final Map<String, Integer> counts = new TreeMap<>(); // of the writes to each key
  private long flushDelayNs;
  private long lastDueNs;
  private @Nullable Timer timer;
  private boolean isHalted;

  /**
   * @param clock the run's true time
   * @param flushDelayNs the duration of a flush; 0 flushes in the strand's next piece
   */
  public SimStable(Clock clock, long flushDelayNs) {
    this.clock = clock;
    setFlushDelay(flushDelayNs);
  }

  /** Ends the program: later flushes do not happen, and writes during unwinding have no effect. */
  public void halt() {
    isHalted = true;
    if (timer != null) {
      timer.cancel();
    }
  }

  /** The number of unflushed writes. */
  public int unflushed() {
    return pending.size();
  }

  /** Whether one is to a key that is written no more often than half of the keys. */
  public boolean isRareUnflushed() {
    if (pending.isEmpty()) {
      return false;
    }
    int[] all = counts.values().stream().mapToInt(Integer::intValue).sorted().toArray();
    return pending.stream()
        .anyMatch(write -> counts.getOrDefault(write.key, 0) <= all[(all.length - 1) / 2]);
  }

  /** Serves a new incarnation; unflushed writes are lost. */
  public void restart(Timers strandTimers) {
    restart(strandTimers, 0);
  }

  /**
   * Serves a new incarnation.
   *
   * @param surviving number of unflushed writes that survive, earliest first; at most {@link
   *     #unflushed}
   */
  public void restart(Timers strandTimers, int surviving) {
    halt();
    for (int i = 0; i < surviving; i++) {
      apply(pending.remove());
    }
    pending.clear();
    timer = strandTimers.timer(this::flush);
    isHalted = false;
  }

  /** Sets the delay of later writes; the order of writes does not change. */
  public void setFlushDelay(long newFlushDelayNs) {
    if (newFlushDelayNs < 0) {
      throw new IllegalArgumentException("delay " + newFlushDelayNs + " ns: expected at least 0");
    }
    flushDelayNs = newFlushDelayNs;
  }

  @Override
  public byte @Nullable [] get(String key) {
    byte[] value = flushed.get(key);
    for (Write write : pending) {
      value = write.key.equals(key) ? write.value : value;
    }
    return value == null ? null : value.clone();
  }

  @Override
  public void put(String key, byte[] value, Runnable onFlushed) {
    byte[] copy = value.clone();
    enqueue(new Write(key, copy, onFlushed, dueNs()));
  }

  @Override
  public void remove(String key) {
    enqueue(new Write(key, null, () -> {}, dueNs()));
  }

  private long dueNs() {
    lastDueNs = Math.max(lastDueNs, clock.nowNs() + flushDelayNs);
    return lastDueNs;
  }

  private void enqueue(Write write) {
    if (timer == null) {
      throw new IllegalStateException("stable storage is used before restart gave it a strand");
    }
    if (isHalted) {
      return;
    }
    pending.add(write);
    counts.merge(write.key, 1, Integer::sum);
    if (pending.size() == 1) {
      timer.set(write.dueNs);
    }
  }

  // One write per piece: a write by a callback is not flushed in the same piece.
  private void flush() {
    Write write = pending.remove();
    apply(write);
    Write next = pending.peek();
    if (next != null && timer != null) {
      timer.set(next.dueNs);
    }
    write.onFlushed.run();
  }

  private void apply(Write write) {
    if (write.value == null) {
      flushed.remove(write.key);
    } else {
      flushed.put(write.key, write.value);
    }
  }

  private static final class Write {
    private final String key;
    private final byte @Nullable [] value;
    private final Runnable onFlushed;
    private final long dueNs;

    Write(String key, byte @Nullable [] value, Runnable onFlushed, long dueNs) {
      this.key = key;
      this.value = value;
      this.onFlushed = onFlushed;
      this.dueNs = dueNs;
    }
  }
}
