package org.starl.primitives.suspicion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.id.ProcessId;

/**
 * One robot's suspicion of crashes, by silence: nothing heard of a participant for {@code silenceNs}
 * while something is needed of it. A guess, which may be wrong at any time and is taken back when the
 * silence ends; nothing safe may rest on it.
 *
 * <p>Pure and clock-driven. All times are of one clock that never runs backwards, in ns. Lists are in
 * the order of the participants. Strand only.
 */
public final class Suspicion {

  private final long silenceNs;
  private final TreeMap<ProcessId, Long> silentSinceNs = new TreeMap<>();

  /**
   * @param silenceNs how long a needed participant may be silent, above 0; a short time suspects
   *     slow ones wrongly, a long one lets everybody wait for the crashed
   */
  public Suspicion(long silenceNs) {
    if (silenceNs <= 0) {
      throw new IllegalArgumentException("silence of " + silenceNs + " ns: expected above 0");
    }
    this.silenceNs = silenceNs;
  }

  /** Something is needed of {@code peer}: its silence counts from now. No-op if it counts already. */
  public void expects(ProcessId peer, long nowNs) {
    silentSinceNs.putIfAbsent(peer, nowNs);
  }

  /**
   * Something has come from {@code peer}: a message, or the acknowledgement of one, which says that
   * it is alive and no more. Its silence, if it counts, begins anew; a suspicion is taken back.
   */
  public void heard(ProcessId peer, long nowNs) {
    silentSinceNs.computeIfPresent(peer, (id, since) -> Math.max(since, nowNs));
  }

  /** Nothing is needed of {@code peer} any more; it is not suspected until it is needed again. */
  public void releases(ProcessId peer) {
    silentSinceNs.remove(peer);
  }

  /** Whether {@code peer} is needed and has been silent for too long. */
  public boolean suspects(ProcessId peer, long nowNs) {
    Long since = silentSinceNs.get(peer);
    return since != null && isTooLong(since, nowNs);
  }

  /** All suspects, in order. */
  public List<ProcessId> suspects(long nowNs) {
    List<ProcessId> suspects = new ArrayList<>();
    for (Map.Entry<ProcessId, Long> entry : silentSinceNs.entrySet()) {
      if (isTooLong(entry.getValue(), nowNs)) {
        suspects.add(entry.getKey());
      }
    }
    return suspects;
  }

  /** All of whom something is needed, suspects or not, in order. */
  public List<ProcessId> expected() {
    return List.copyOf(silentSinceNs.keySet());
  }

  /**
   * The next time to look: the earliest after {@code nowNs} at which another one is suspected if
   * nothing is heard until then; {@code Long.MAX_VALUE} if there is none.
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
