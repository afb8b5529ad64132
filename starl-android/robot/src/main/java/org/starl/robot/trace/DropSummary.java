package org.starl.robot.trace;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceSink;

/**
 * A trace whose length a flood of datagrams cannot decide. The first dropped datagram of each sender
 * and reason is recorded, for {@link #MAX_SENDERS} such pairs; the others are counted, and the counts are
 * actions {@code network dropped}, at most one a second for each reason. Other events pass unchanged.
 * From any thread.
 */
public final class DropSummary implements TraceSink {

  static final int MAX_SENDERS = 64;
  private static final long PERIOD_NS = Time.NS_PER_S;

  private final RobotId self;
  private final TraceSink trace;
  private final TreeSet<String> seen = new TreeSet<>();
  private final TreeMap<String, Long> counts = new TreeMap<>();
  private long dueNs;

  public DropSummary(RobotId self, TraceSink trace) {
    this.self = self;
    this.trace = trace;
  }

  @Override
  public boolean isOn() {
    return trace.isOn();
  }

  @Override
  public synchronized void record(TraceEvent event) {
    if (event instanceof Dropped drop && !isFirst(drop)) {
      if (counts.isEmpty()) {
        dueNs = drop.timeNs() + PERIOD_NS;
      }
      counts.merge(drop.why(), 1L, Long::sum);
    } else {
      trace.record(event);
    }
    if (!counts.isEmpty() && event.timeNs() >= dueNs) {
      flush(event.timeNs());
    }
  }

  /** Records the remaining counts. */
  public synchronized void flush(long timeNs) {
    for (Map.Entry<String, Long> count : counts.entrySet()) {
      List<String> args = List.of(count.getKey(), count.getValue().toString());
      trace.record(new Action(timeNs, self, "network", "dropped", args));
    }
    counts.clear();
  }

  private boolean isFirst(Dropped drop) {
    return seen.size() < MAX_SENDERS && seen.add(drop.from() + ' ' + drop.why());
  }
}
