package org.starl.sim.world;

import java.util.PriorityQueue;
import org.starl.platform.Clock;
import org.starl.platform.Timer;
import org.starl.platform.Timers;

/** A kernel of a few lines: virtual time and timers, events in the order of time, then of setting. */
public final class TestTime implements Clock, Timers {

  private final PriorityQueue<Event> queue = new PriorityQueue<>();
  private long nowNs;
  private long sequence;
  private long events;

  @Override
  public long nowNs() {
    return nowNs;
  }

  /** The number of events run so far. */
  public long events() {
    return events;
  }

  /** Runs {@code action} at {@code atNs}, or now if that is past, later than this call. */
  public void schedule(long atNs, Runnable action) {
    queue.add(new Event(Math.max(atNs, nowNs), sequence++, action));
  }

  /** Runs everything that is due until {@code untilNs}, and stays there. */
  public void runUntil(long untilNs) {
    Event next = queue.peek();
    while (next != null && next.atNs <= untilNs) {
      queue.remove();
      nowNs = next.atNs;
      events++;
      next.action.run();
      next = queue.peek();
    }
    nowNs = untilNs;
  }

  public void runFor(double seconds) {
    runUntil(nowNs + (long) (seconds * 1e9));
  }

  @Override
  public Timer timer(Runnable action) {
    return new TestTimer(action);
  }

  private record Event(long atNs, long number, Runnable action) implements Comparable<Event> {
    @Override
    public int compareTo(Event other) {
      int byTime = Long.compare(atNs, other.atNs);
      return byTime != 0 ? byTime : Long.compare(number, other.number);
    }
  }

  private final class TestTimer implements Timer {
    private final Runnable action;
    private long setting;
    private long setForNs;
    private boolean isSet;

    TestTimer(Runnable action) {
      this.action = action;
    }

    @Override
    public void set(long atNs) {
      if (isSet && atNs == setForNs) {
        return;
      }
      setting++;
      isSet = atNs != NEVER;
      setForNs = atNs;
      long mine = setting;
      schedule(
          atNs,
          () -> {
            if (isSet && setting == mine) {
              isSet = false;
              action.run();
            }
          });
    }

    @Override
    public void cancel() {
      isSet = false;
    }

    @Override
    public boolean isSet() {
      return isSet;
    }
  }
}
