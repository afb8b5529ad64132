package org.starl.primitives.chaos;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/**
 * Virtual time, and a network that loses, delays, doubles, reorders and cuts, all from one seed. The
 * specification watches.
 */
public abstract class FoulNetwork {

  public static final long NS_PER_MS = 1_000_000;

  public final Rng rng;
  public final List<TraceEvent> trace = new ArrayList<>();
  private final Monitors monitors;

  /** What the network and the disks are like now. */
  public Weather weather = Weather.FAIR;

  /** Robots below this index cannot hear those at or above it, and the reverse; 0 for no cut. */
  public int cutAt;

  private long sent;
  private long nowNs;
  private long seq;
  private final TreeMap<Due, Runnable> queue = new TreeMap<>();

  private record Due(long atNs, long seq) implements Comparable<Due> {
    @Override
    public int compareTo(Due other) {
      int byTime = Long.compare(atNs, other.atNs);
      return byTime != 0 ? byTime : Long.compare(seq, other.seq);
    }
  }

  protected FoulNetwork(long seed, Monitor... specs) {
    rng = new Rng(seed);
    monitors = new Monitors(List.of(specs));
  }

  /** A robot's place in the order of all. */
  protected abstract int indexOf(RobotId name);

  /** How many messages have been sent so far. */
  public long sent() {
    return sent;
  }

  public long nowNs() {
    return nowNs;
  }

  public long nowMs() {
    return nowNs / NS_PER_MS;
  }

  public void at(long atNs, Runnable action) {
    queue.put(new Due(Math.max(atNs, nowNs), seq++), action);
  }

  public void afterMs(long ms, Runnable action) {
    at(nowNs + ms * NS_PER_MS, action);
  }

  public void runForMs(long ms) {
    runUntil(() -> false, ms);
  }

  /** Runs until {@code done} or the time is over; returns whether it was done. */
  public boolean runUntil(BooleanSupplier done, long withinMs) {
    long endNs = nowNs + withinMs * NS_PER_MS;
    while (!done.getAsBoolean()) {
      if (queue.isEmpty() || queue.firstKey().atNs() > endNs) {
        nowNs = endNs;
        return false;
      }
      Map.Entry<Due, Runnable> next = queue.pollFirstEntry();
      nowNs = next.getKey().atNs();
      next.getValue().run();
    }
    return true;
  }

  public SpecReport finish() {
    monitors.finish(nowNs);
    return monitors.report();
  }

  public void record(TraceEvent event) {
    trace.add(event);
    monitors.observe(event);
  }

  /** One transmission; {@code arrived} runs for each copy that comes through. */
  public void transmit(RobotId from, RobotId to, Runnable arrived) {
    sent++;
    if (from.equals(to)) {
      at(nowNs, arrived);
      return;
    }
    if (isCut(from, to) || rng.nextBoolean(weather.loss())) {
      return;
    }
    int copies = rng.nextBoolean(weather.duplicate()) ? 2 : 1;
    for (int i = 0; i < copies; i++) {
      afterMs(rng.nextLong(weather.minDelayMs(), weather.maxDelayMs()), arrived);
    }
  }

  private boolean isCut(RobotId from, RobotId to) {
    return cutAt > 0 && (indexOf(from) < cutAt) != (indexOf(to) < cutAt);
  }
}
