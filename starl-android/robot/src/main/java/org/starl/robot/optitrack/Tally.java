package org.starl.robot.optitrack;

import java.util.Set;
import java.util.TreeSet;
import org.starl.platform.LogSink;
import org.starl.robot.udp.DropCounts;

/** A feed's counters; logs the first drop for each reason. One thread at a time. */
final class Tally {

  private final LogSink log;
  private final String tag;
  private final DropCounts<FeedDrop> drops = new DropCounts<>(FeedDrop.class);
  private final Set<String> warned = new TreeSet<>();
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
    // Early datagrams are normal at a start.
    if (drops.add(why) && why != FeedDrop.EARLY) {
      log.log(nowNs, LogSink.Level.WARN, tag, what + "; further ones are only counted: " + why);
    }
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
