package org.starl.robot.optitrack;

import java.util.EnumMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.starl.platform.LogSink;

/** Counts what a feed hears, and logs the first of each kind that it drops. One thread at a time. */
final class Tally {

  private final LogSink log;
  private final String tag;
  private final long[] dropped = new long[FeedDrop.values().length];
  private final Set<String> told = new TreeSet<>();
  private long received;
  private long fixes;

  Tally(LogSink log, String tag) {
    this.log = log;
    this.tag = tag;
  }

  void received() {
    received++;
  }

  void fixed() {
    fixes++;
  }

  void drop(FeedDrop why, String what, long nowNs) {
    dropped[why.ordinal()]++;
    // What comes early is no fault of anybody.
    if (dropped[why.ordinal()] == 1 && why != FeedDrop.EARLY) {
      log.log(nowNs, LogSink.Level.WARN, tag, what + "; further ones are only counted: " + why);
    }
  }

  void info(String what, long nowNs) {
    log.log(nowNs, LogSink.Level.INFO, tag, what);
  }

  /** Warns once for each {@code kind}, of which there are few. */
  void warnOnce(String kind, String what, long nowNs) {
    if (told.add(kind)) {
      log.log(nowNs, LogSink.Level.WARN, tag, what);
    }
  }

  FeedStatistics statistics() {
    Map<FeedDrop, Long> counts = new EnumMap<>(FeedDrop.class);
    for (FeedDrop why : FeedDrop.values()) {
      counts.put(why, dropped[why.ordinal()]);
    }
    return new FeedStatistics(received, fixes, counts);
  }
}
