package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_S;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.platform.LogSink;
import org.starl.robot.udp.DropCounts;

/**
 * A feed's counters; logs the first drop for each reason, and the first jump of each episode. One
 * thread at a time.
 */
final class Tally {

  /** An episode of jumps ends after this time without any. */
  static final long EPISODE_NS = 10 * NS_PER_S;

  /** Bodies whose jumps are logged; those of further ones are only counted. */
  private static final int MOST_TOLD = 64;

  private final LogSink log;
  private final String tag;
  private final DropCounts<FeedDrop> drops = new DropCounts<>(FeedDrop.class);
  private final Set<String> warned = new TreeSet<>();
  private final Map<String, Long> jumpedNs = new TreeMap<>();
  private long received;
  private long fixes;

  Tally(LogSink log, String tag) {
    this.log = log;
    this.tag = tag;
  }

  void received() {
    received++;
  }

  void drop(FeedDrop why, String what, long nowNs) {
    // Early datagrams are normal at a start.
    if (drops.add(why) && why != FeedDrop.EARLY) {
      log.log(nowNs, LogSink.Level.WARN, tag, what + "; further ones are only counted: " + why);
    }
  }

  /**
   * Judges a fix; counts it if it is dropped.
   *
   * @return whether to use it
   */
  boolean admit(PoseGate gate, String name, Fix fix, long nowNs) {
    Fix before = gate.before();
    switch (gate.judge(fix)) {
      case PASSED -> {
        fixes++;
        return true;
      }
      case MOVED -> {
        fixes++;
        warn(name + " was moved by hand: it is at " + PoseGate.text(fix.pose()), nowNs);
        return true;
      }
      case OUTDATED -> drop(FeedDrop.OUTDATED, "a newer fix of " + name + " came before", nowNs);
      case EARLY -> drops.add(FeedDrop.EARLY);
      case JUMPED -> jumped(name, before, fix, nowNs);
    }
    return false;
  }

  private void jumped(String name, @Nullable Fix before, Fix fix, long nowNs) {
    drops.add(FeedDrop.JUMPED);
    // Names of robots are few, names that an attacker invents are many.
    boolean isFull = jumpedNs.size() >= MOST_TOLD && !jumpedNs.containsKey(name);
    Long lastNs = isFull ? Long.valueOf(nowNs) : jumpedNs.put(name, nowNs);
    if (lastNs == null || nowNs - lastNs > EPISODE_NS) {
      String from = before == null ? "the fix before it" : PoseGate.text(before.pose());
      warn(
          name
              + " jumps from "
              + from
              + " to "
              + PoseGate.text(fix.pose())
              + ": faster than a robot drives, so no fix; further ones are only counted: "
              + FeedDrop.JUMPED,
          nowNs);
    }
  }

  private void warn(String what, long nowNs) {
    log.log(nowNs, LogSink.Level.WARN, tag, what);
  }

  void info(String what, long nowNs) {
    log.log(nowNs, LogSink.Level.INFO, tag, what);
  }

  /** Warns once for each {@code kind}, of which there are few. */
  void warnOnce(String kind, String what, long nowNs) {
    if (warned.add(kind)) {
      log.log(nowNs, LogSink.Level.WARN, tag, what);
    }
  }

  FeedStatistics statistics() {
    return new FeedStatistics(received, fixes, drops.counts());
  }
}
