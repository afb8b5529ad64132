package org.starl.primitives.suspicion;

import java.util.List;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.starl.id.ProcessId;

/**
 * One robot's crash detector, by silence: it suspects a participant that is needed and was not heard for
 * {@code silenceNs}. A suspicion may be wrong at any time, and ends with the silence; safety must not
 * depend on it.
 *
 * <p>Pure and clock-driven. Times are of one clock that never runs backwards, in ns. Lists are in the
 * order of the participants. Strand only.
 */
public final class Suspicion {

  private final long silenceNs;
  private final TreeMap<ProcessId, Long> silentSinceNs = new TreeMap<>();

  /**
   * @param silenceNs how long a needed participant may be silent, above 0; a short time suspects slow
   *     participants wrongly, a long one makes robots wait longer for crashed participants
   */
  public Suspicion(long silenceNs) {
    if (silenceNs <= 0) {
      throw new IllegalArgumentException("silence of " + silenceNs + " ns: expected above 0");
    }
    this.silenceNs = silenceNs;
  }

  /** {@code peer} is needed: its silence counts from now, if it does not count already. */
  public void expect(ProcessId peer, long nowNs) {
    silentSinceNs.putIfAbsent(peer, nowNs);
  }

  /**
   * {@code peer} was heard: a message, or an acknowledgement. Its silence, if it counts, starts again,
   * and a suspicion ends.
   */
  public void heard(ProcessId peer, long nowNs) {
    silentSinceNs.computeIfPresent(peer, (id, since) -> Math.max(since, nowNs));
  }

  /** {@code peer} is no longer needed: it is not suspected until it is needed again. */
  public void release(ProcessId peer) {
    silentSinceNs.remove(peer);
  }

  /** Whether {@code peer} is needed and has been silent for too long. */
  public boolean suspects(ProcessId peer, long nowNs) {
    Long since = silentSinceNs.get(peer);
    return since != null && isTooLong(since, nowNs);
  }

  /** All suspects, in order. */
  public List<ProcessId> suspects(long nowNs) {
    return silentSinceNs.keySet().stream()
        .filter(peer -> suspects(peer, nowNs))
        .collect(Collectors.toList());
  }

  /** All needed participants, suspected or not, in order. */
  public List<ProcessId> expected() {
    return List.copyOf(silentSinceNs.keySet());
  }

  /**
   * The earliest time after {@code nowNs} at which another participant becomes suspected if nothing is
   * heard until then; {@code Long.MAX_VALUE} if there is none.
   */
  public long wakeAtNs(long nowNs) {
    long earliestNs = Long.MAX_VALUE;
    for (long since : silentSinceNs.values()) {
      if (!isTooLong(since, nowNs)) {
        earliestNs = Math.min(earliestNs, since + silenceNs);
      }
    }
    return earliestNs;
  }

  private boolean isTooLong(long sinceNs, long nowNs) {
    return nowNs - sinceNs >= silenceNs;
  }
}
