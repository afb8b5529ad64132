package org.starl.sim.explore;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.sim.OrderObserver;
import org.starl.sim.net.Transmission;
import org.starl.trace.TraceEvent;

/**
 * The order of the events of one run, from the instant at which exploration begins: the copies that
 * were sent, and the times of each robot's events. It keeps the first copies, and the events until
 * the last of these can have arrived.
 */
public final class Order implements OrderObserver {

  private static final long HASH = 0x9E3779B97F4A7C15L;

  private final Bounds bounds;
  private final int mostCopies;
  private final List<Copy> copies = new ArrayList<>();
  private final Map<String, TraceEvent.Sent> messages = new LinkedHashMap<>();
  private final Map<String, List<Long>> events = new LinkedHashMap<>();
  private long untilNs = Long.MAX_VALUE;
  private long steps;
  private long endNs;

  /**
   * @param mostCopies the number of copies to keep, at least 1
   */
  Order(Bounds bounds, int mostCopies) {
    this.bounds = bounds;
    this.mostCopies = mostCopies;
  }

  @Override
  public void sent(Transmission copy, long delayNs) {
    if (copy.sentAtNs() < bounds.fromNs() || copies.size() == mostCopies) {
      return;
    }
    long arrivesAtNs = delayNs == LOST ? Copy.NEVER : copy.sentAtNs() + delayNs;
    copies.add(
        new Copy(
            copy.from().name(), copy.to().name(), copy.datagram(), copy.sentAtNs(), arrivesAtNs));
    if (copies.size() == mostCopies) {
      untilNs = copy.sentAtNs() + bounds.mostDelayNs();
    }
  }

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof TraceEvent.Sent sent
        && sent.timeNs() >= bounds.fromNs()
        && copies.size() < mostCopies) {
      messages.put(place(sent.robot().name(), sent.to(), sent.timeNs()), sent);
    }
  }

  private static String place(String from, String to, long sentAtNs) {
    return from + ">" + to + "@" + sentAtNs;
  }

  /** The message in {@code copy} as text; empty if it is not known. */
  String message(Copy copy) {
    TraceEvent.Sent one = messages.get(place(copy.from(), copy.to(), copy.sentAtNs()));
    TraceEvent.Sent sent =
        one != null ? one : messages.get(place(copy.from(), TraceEvent.Sent.ALL, copy.sentAtNs()));
    return sent == null ? "" : sent.channel() + " " + sent.message();
  }

  @Override
  public void ran(long timeNs, String robot) {
    steps++;
    endNs = timeNs;
    if (!robot.isEmpty() && timeNs >= bounds.fromNs() && timeNs <= untilNs) {
      events.computeIfAbsent(robot, any -> new ArrayList<>()).add(timeNs);
    }
  }

  /** In the order of sending. */
  List<Copy> copies() {
    return copies;
  }

  /** The number of events that the kernel ran, in the whole run. */
  long steps() {
    return steps;
  }

  /** The time of the last event. */
  long endNs() {
    return endNs;
  }

  /**
   * Other times at which {@code copy} could arrive: the middle of each gap between two events of its
   * recipient, so that there is room for other copies before and after it; but for the gap in which
   * it arrives.
   */
  List<Long> otherArrivals(Copy copy) {
    long firstNs = copy.sentAtNs() + bounds.leastDelayNs();
    long lastNs = copy.sentAtNs() + bounds.mostDelayNs();
    List<Long> arrivals = new ArrayList<>();
    long gapNs = firstNs;
    for (long eventNs : events.getOrDefault(copy.to(), List.of())) {
      if (eventNs < firstNs || eventNs == copy.arrivesAtNs()) {
        continue;
      }
      if (eventNs >= lastNs) {
        break;
      }
      addArrival(copy, gapNs, eventNs, arrivals);
      gapNs = eventNs + 1;
    }
    addArrival(copy, gapNs, lastNs + 1, arrivals);
    return arrivals;
  }

  /** Adds an arrival from {@code fromNs}, before {@code untilNs}, unless it is there already. */
  private static void addArrival(Copy copy, long fromNs, long untilNs, List<Long> arrivals) {
    boolean isThere = copy.arrivesAtNs() >= fromNs && copy.arrivesAtNs() < untilNs;
    if (fromNs < untilNs && !isThere) {
      arrivals.add(fromNs + (untilNs - fromNs) / 2);
    }
  }

  /**
   * A hash of the order in which each robot had its events and the kept copies. Two runs with equal
   * orders differ in their times alone.
   */
  long hash() {
    long hash = 0;
    for (Map.Entry<String, List<Long>> robot : events.entrySet()) {
      hash += robotHash(robot.getKey(), robot.getValue());
    }
    for (Copy copy : copies) {
      hash += copy.isLost() ? mixed(identity(copy)) : 0;
    }
    return hash;
  }

  private long robotHash(String robot, List<Long> times) {
    Map<Long, Long> arrivals = new LinkedHashMap<>();
    for (Copy copy : copies) {
      if (copy.to().equals(robot)) {
        arrivals.merge(copy.arrivesAtNs(), identity(copy), Long::sum);
      }
    }
    long hash = robot.hashCode();
    for (long timeNs : times) {
      hash = mixed(hash + arrivals.getOrDefault(timeNs, 1L));
    }
    return hash;
  }

  private static long identity(Copy copy) {
    return mixed(copy.from().hashCode() * HASH + copy.to().hashCode()) + copy.datagram();
  }

  /** Spreads each bit over the number (Steele et al., SplitMix64). */
  private static long mixed(long number) {
    long z = (number + HASH) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }
}
