package org.starl.testing;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.trace.TraceEvent;

/**
 * Several {@link FakePlatform}s in one virtual time, and the radio between them. Events of equal
 * time happen in the order in which they were made.
 */
public final class FakeWorld {

  /** Says when copies of a datagram arrive: delays in ns; an empty array is a loss. */
  @FunctionalInterface
  public interface Rule {
    long[] delaysNs(RobotId from, RobotId to, byte[] datagram);
  }

  private record Event(long atNs, long serial, Runnable action) {}

  /** What every robot of this world recorded, in order; filled while {@link #tracing}. */
  public final List<TraceEvent> trace = new ArrayList<>();

  public boolean tracing = true;

  /** What datagrams are sealed with; none unless set before a robot boots. */
  public @Nullable DeploymentKey key;

  /** What the radio does to datagrams; set anew at will. By default each takes 1 ms. */
  public Rule rule = (from, to, datagram) -> new long[] {NS_PER_MS};

  private final PriorityQueue<Event> events =
      new PriorityQueue<>(Comparator.comparingLong(Event::atNs).thenComparingLong(Event::serial));
  private final Map<RobotId, FakePlatform> robots = new TreeMap<>();
  private final Map<RobotId, Integer> starts = new TreeMap<>();
  private final Participants deployment;
  private long nowNs;
  private long serial;

  public FakeWorld(String... names) {
    deployment = Participants.of(Arrays.stream(names).map(RobotId::new).toList());
  }

  /** Starts, or restarts with nothing kept but stable storage, the robot of this name. */
  public FakePlatform boot(String name) {
    RobotId id = new RobotId(name);
    FakePlatform before = robots.get(id);
    if (before != null) {
      before.isUp = false;
    }
    starts.merge(id, 1, Integer::sum);
    FakePlatform robot =
        new FakePlatform(this, id, deployment, before == null ? new TreeMap<>() : before.stored);
    robots.put(id, robot);
    return robot;
  }

  /** How often the robot has started. */
  int starts(RobotId robot) {
    return starts.getOrDefault(robot, 0);
  }

  public long nowNs() {
    return nowNs;
  }

  /** Does everything that is due up to {@code ms} milliseconds from now. */
  public void runMs(long ms) {
    long untilNs = nowNs + ms * NS_PER_MS;
    while (step(untilNs)) {
      continue;
    }
  }

  /** Does the next event if there is one until {@code untilNs}; else it is that time. */
  boolean step(long untilNs) {
    Event next = events.peek();
    if (next == null || next.atNs > untilNs) {
      nowNs = Math.max(nowNs, untilNs);
      return false;
    }
    events.poll();
    nowNs = Math.max(nowNs, next.atNs);
    next.action.run();
    return true;
  }

  void at(long atNs, Runnable action) {
    serial++;
    events.add(new Event(Math.max(atNs, nowNs), serial, action));
  }

  /** Lets these bytes arrive at {@code to} as they are, after what is due now. */
  public void inject(RobotId to, byte[] datagram) {
    at(nowNs, () -> arrive(to, datagram));
  }

  void transmit(RobotId from, RobotId to, byte[] datagram) {
    for (long delayNs : rule.delaysNs(from, to, datagram)) {
      at(nowNs + delayNs, () -> arrive(to, datagram));
    }
  }

  void broadcast(RobotId from, byte[] datagram) {
    for (RobotId to : robots.keySet()) {
      if (!to.equals(from)) {
        transmit(from, to, datagram);
      }
    }
  }

  // A copy each time: the receiver's buffer is valid during the call only.
  private void arrive(RobotId to, byte[] datagram) {
    FakePlatform robot = robots.get(to);
    if (robot != null) {
      byte[] buffer = datagram.clone();
      robot.arrive(buffer, buffer.length);
      Arrays.fill(buffer, (byte) 0xEE);
    }
  }
}
