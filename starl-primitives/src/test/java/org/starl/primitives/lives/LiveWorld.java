package org.starl.primitives.lives;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.starl.RobotId;
import org.starl.random.Rng;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/**
 * Robots with one pure protocol each, in virtual time, over a network that loses, delays, doubles,
 * reorders and cuts, all from one seed. The specification watches.
 */
public final class LiveWorld<R extends LiveRobot> {

  static final long NS_PER_MS = 1_000_000;

  private static final String FOUL = "foul";

  public final Rng rng;
  public final List<R> robots = new ArrayList<>();
  public final List<TraceEvent> trace = new ArrayList<>();
  private final Monitors monitors;

  private Weather weather = Weather.FAIR;
  private int cutAt;
  private boolean isFoul;
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

  public LiveWorld(long seed, Monitor spec) {
    rng = new Rng(seed);
    monitors = new Monitors(List.of(spec));
  }

  /** Adds robots {@code bot0}, {@code bot1}, ..., none of them started. */
  public void add(int count, Function<RobotId, R> maker) {
    for (int i = 0; i < count; i++) {
      robots.add(maker.apply(new RobotId("bot" + i)));
    }
  }

  /** What the network and the disks are like from now on; anything but fair is told as a fault. */
  public void weather(Weather newWeather) {
    weather = newWeather;
    tellFault();
  }

  /** Robots below this index and those at or above it cannot hear each other; 0 for no cut. */
  public void cutAt(int index) {
    cutAt = index;
    tellFault();
  }

  private void tellFault() {
    boolean nowFoul = cutAt > 0 || weather.loss() > 0 || weather.maxDelayMs() > 50;
    if (nowFoul != isFoul) {
      isFoul = nowFoul;
      String name = nowFoul ? TraceEvent.Fault.BEGIN : TraceEvent.Fault.END;
      record(new TraceEvent.Fault(nowNs, TraceEvent.Fault.WORLD, name, FOUL));
    }
  }

  Weather weather() {
    return weather;
  }

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
  void transmit(RobotId from, RobotId to, Runnable arrived) {
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

  private int indexOf(RobotId name) {
    for (int i = 0; i < robots.size(); i++) {
      if (robots.get(i).name.equals(name)) {
        return i;
      }
    }
    throw new IllegalArgumentException("no robot " + name);
  }

  R robot(RobotId name) {
    return robots.get(indexOf(name));
  }
}
