package org.starl.robot.trace;

import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.RobotId;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceSink;
import org.starl.trace.Vocabulary;

/**
 * A trace whose length a flood of datagrams cannot decide. The first dropped datagram of each sender
 * and reason is recorded, for {@link #MAX_SENDERS} such pairs; the others are counted, and the counts are
 * facts {@code network dropped}, at most one a second for each reason. Other events pass unchanged.
 * From any thread.
 */
public final class DropSummary implements TraceSink {

  /**
   * So many datagrams were dropped for this reason.
   *
   * @param why as in {@link Dropped}
   */
  public record Count(String why, long datagrams) {

    /** Its shape. */
    public static final RecordShape<Count> SHAPE =
        Shapes.of(
                Count.class,
                Shapes.part("why", Shapes.TEXT, Count::why),
                Shapes.part("datagrams", Shapes.LONG, Count::datagrams),
                Count::new)
            .named("dropped");
  }

  private static final Instance SOURCE = Instance.of("network");

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      Vocabulary.NONE.facts(SOURCE.primitive(), Count.SHAPE);

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
      Count fact = new Count(count.getKey(), count.getValue());
      trace.record(Action.of(timeNs, self, SOURCE, Count.SHAPE, fact));
    }
    counts.clear();
  }

  private boolean isFirst(Dropped drop) {
    return seen.size() < MAX_SENDERS && seen.add(drop.from() + ' ' + drop.why());
  }
}
