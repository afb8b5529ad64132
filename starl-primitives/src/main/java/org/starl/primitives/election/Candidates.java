package org.starl.primitives.election;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.id.ProcessId;

/** The candidates of the present term, as far as this robot has heard. */
final class Candidates {

  private final ProcessId me;
  private final long beganNs;
  private final long deltaNs;
  private final TreeMap<ProcessId, Standing> standings = new TreeMap<>();

  private record Standing(long draw, long heardNs) {}

  /**
   * @param beganNs when this robot became a candidate in this term
   * @param deltaNs how long a message may take, in ns
   */
  Candidates(ProcessId me, long draw, long beganNs, long deltaNs) {
    this.me = me;
    this.beganNs = beganNs;
    this.deltaNs = deltaNs;
    standings.put(me, new Standing(draw, Long.MAX_VALUE));
  }

  /** Hears of a candidate; returns whether for the first time. */
  boolean heard(ProcessId candidate, long draw, long nowNs) {
    return !candidate.equals(me) && standings.put(candidate, new Standing(draw, nowNs)) == null;
  }

  /** The candidate is known to be dead. */
  void strike(ProcessId candidate) {
    standings.remove(candidate);
  }

  ProcessId me() {
    return me;
  }

  long beganNs() {
    return beganNs;
  }

  /** {@code count} message delays, in ns. */
  long delaysNs(long count) {
    return count * deltaNs;
  }

  /** Whether a candidate with a higher id was heard at or after {@code sinceNs}. */
  boolean hasHigherThanMe(long sinceNs) {
    return standings.tailMap(me, false).values().stream().anyMatch(s -> s.heardNs() >= sinceNs);
  }

  /** The candidates heard at or after {@code sinceNs}, and this one: highest draw first, then highest id. */
  List<ProcessId> byDraw(long sinceNs) {
    List<Map.Entry<ProcessId, Standing>> entries = new ArrayList<>(standings.entrySet());
    entries.sort(
        Comparator.comparingLong((Map.Entry<ProcessId, Standing> entry) -> entry.getValue().draw())
            .thenComparing(Map.Entry::getKey)
            .reversed());
    List<ProcessId> heard = new ArrayList<>();
    for (Map.Entry<ProcessId, Standing> entry : entries) {
      if (entry.getValue().heardNs() >= sinceNs) {
        heard.add(entry.getKey());
      }
    }
    return heard;
  }
}
