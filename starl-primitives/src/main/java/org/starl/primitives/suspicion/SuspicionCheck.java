package org.starl.primitives.suspicion;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.spec.Deadlines.ProcessKey;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * Checks, in a trace, that a robot suspects no participant that it has heard within the silence: a lemma
 * of each primitive that suspects. Only by clocks that run right.
 */
public final class SuspicionCheck {

  private final String lemma;
  private final FaultState faults;
  private final Map<ProcessKey, Map<ProcessId, Long>> heardNs = new LinkedHashMap<>();
  private long silenceNs;

  /** Checks nothing before {@link #setSilence}. */
  public SuspicionCheck(String lemma, FaultState faults) {
    this.lemma = lemma;
    this.faults = faults;
  }

  /** A participant may be suspected after this time of silence, in ns. */
  public void setSilence(long ns) {
    silenceNs = ns;
  }

  /** The event's robot hears {@code peer}, or needs it from now on. */
  public void heard(Instance source, TraceEvent event, ProcessId peer) {
    if (silenceNs > 0) {
      heardNs
          .computeIfAbsent(new ProcessKey(source, event.robot()), key -> new LinkedHashMap<>())
          .put(peer, event.timeNs());
    }
  }

  /**
   * The event's robot acts as if {@code peer} had crashed. It may, if it has heard a later start of the
   * peer's robot.
   *
   * @param neededNs since when the peer is needed at least; its silence counts from then
   */
  public void suspects(
      Instance source, TraceEvent event, ProcessId peer, long neededNs, Report report) {
    var heard = heardNs.getOrDefault(new ProcessKey(source, event.robot()), Map.of());
    long sinceNs = Math.max(heard.getOrDefault(peer, Long.MIN_VALUE), neededNs);
    boolean isDead =
        heard.keySet().stream()
            .anyMatch(id -> id.robot().equals(peer.robot()) && id.inc() > peer.inc());
    if (silenceNs > 0 && !isDead && faults.isClockRight(event.robot(), sinceNs)) {
      report.checked(lemma);
      if (event.timeNs() < sinceNs + silenceNs) {
        String detail =
            String.format(
                "%s: suspects %s after %s ns of silence", source, peer, event.timeNs() - sinceNs);
        report.violated(lemma, event.timeNs(), List.of(event.robot()), detail);
      }
    }
  }

  /** A robot acts, and suspects nobody by that: the lemma holds once more. */
  public void suspectsNobody(Report report) {
    if (silenceNs > 0) {
      report.checked(lemma);
    }
  }

  /** The robot's program has ended. */
  public void ended(RobotId robot) {
    heardNs.keySet().removeIf(key -> key.robot().equals(robot));
  }
}
