package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import org.starl.Participants;
import org.starl.RobotId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.random.Rng;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;

/**
 * Robots of one registration in virtual time, over a network that loses, delays, doubles, reorders
 * and cuts, all from one seed. The specification watches.
 */
final class Town {

  static final String SOURCE = "registration/town";
  static final long NS_PER_MS = 1_000_000;

  /** Makes a robot's protocol; mutants make another one. */
  interface Maker {
    RegistrationProtocol make(
        RobotId self,
        Participants acceptors,
        RegistrationSettings settings,
        Rng rng,
        SynodLink link,
        RegistrationPort port,
        long nowNs);
  }

  final Rng rng;
  final Participants acceptors;
  final Map<RobotId, TownRobot> robots = new TreeMap<>();
  final Monitors monitors;
  final List<TraceEvent> trace = new ArrayList<>();

  Weather weather = Weather.FAIR;
  RegistrationSettings settings = RegistrationSettings.DEFAULT;
  Maker maker =
      (self, who, set, r, link, port, now) ->
          new RegistrationProtocol(self, who, set, r, link, false, port, now);

  /** What becomes of a message on its way. */
  UnaryOperator<SynodMessage> tamper = UnaryOperator.identity();

  boolean acceptorsForget;

  /** Whether writes are said to be stable before they are. */
  boolean flushesLie;

  /** Whether nothing that is sent reliably is sent at all, as by one who goes away at once. */
  boolean newsIsLost;

  /** Whether all robots number their ballots alike. */
  boolean ballotsCollide;

  /** Robots below this index cannot hear those at or above it, and the reverse; 0 for no cut. */
  int cutAt;

  long sent;
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

  Town(long seed, int size, int acceptorCount, Monitor spec) {
    rng = new Rng(seed);
    monitors = new Monitors(List.of(spec));
    List<RobotId> names = new ArrayList<>();
    for (int i = 0; i < size; i++) {
      names.add(new RobotId("bot" + i));
    }
    acceptors = Participants.of(names.subList(0, acceptorCount));
    for (RobotId name : names) {
      robots.put(name, new TownRobot(this, name));
    }
  }

  void startAll() {
    robots.values().forEach(TownRobot::start);
  }

  TownRobot robot(int index) {
    return new ArrayList<>(robots.values()).get(index);
  }

  long nowNs() {
    return nowNs;
  }

  long nowMs() {
    return nowNs / NS_PER_MS;
  }

  void at(long atNs, Runnable action) {
    queue.put(new Due(Math.max(atNs, nowNs), seq++), action);
  }

  void afterMs(long ms, Runnable action) {
    at(nowNs + ms * NS_PER_MS, action);
  }

  void runForMs(long ms) {
    runUntilNs(nowNs + ms * NS_PER_MS);
  }

  /** Runs until {@code done} or the time is over; returns whether it was done. */
  boolean runUntil(BooleanSupplier done, long withinMs) {
    long endNs = nowNs + withinMs * NS_PER_MS;
    while (!done.getAsBoolean()) {
      if (queue.isEmpty() || queue.firstKey().atNs() > endNs) {
        nowNs = endNs;
        return false;
      }
      step();
    }
    return true;
  }

  private void runUntilNs(long endNs) {
    while (!queue.isEmpty() && queue.firstKey().atNs() <= endNs) {
      step();
    }
    nowNs = endNs;
  }

  private void step() {
    Map.Entry<Due, Runnable> next = queue.pollFirstEntry();
    nowNs = next.getKey().atNs();
    next.getValue().run();
  }

  SpecReport finish() {
    monitors.finish(nowNs);
    return monitors.report();
  }

  void record(TraceEvent event) {
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
      long delayMs = rng.nextLong(weather.minDelayMs(), weather.maxDelayMs());
      afterMs(delayMs, arrived);
    }
  }

  private boolean isCut(RobotId from, RobotId to) {
    List<RobotId> names = List.copyOf(robots.keySet());
    return cutAt > 0 && (names.indexOf(from) < cutAt) != (names.indexOf(to) < cutAt);
  }
}
