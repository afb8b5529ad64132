package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.suspicion.Suspicion;

/** The clock of one waiting request: when it is repeated, whom it suspects, when it is given up. */
final class Patience {

  /** Repetitions after which a later view is asked for: who says nothing may have left. */
  private static final int RESENDS_PER_QUERY = 4;

  private final MutexTimes times;
  private final Suspicion suspicion;
  private long begunNs;
  private long deadlineNs = Long.MAX_VALUE;
  private long resendAtNs = Long.MAX_VALUE;
  private long resendNs;
  private int resends;

  Patience(MutexTimes times) {
    this.times = times;
    this.suspicion = new Suspicion(times.suspectMs() * NS_PER_MS);
  }

  void begin(long nowNs) {
    begunNs = nowNs;
    deadlineNs = nowNs + times.deadlineMs() * NS_PER_MS;
    resendNs = times.resendMs() * NS_PER_MS;
    resendAtNs = nowNs + resendNs;
    resends = 0;
  }

  long wakeAtNs() {
    return Math.min(deadlineNs, resendAtNs);
  }

  boolean isOver(long nowNs) {
    return nowNs >= deadlineNs;
  }

  /** Whether to give up if only a ghost stands in the way. */
  boolean isOverForGhosts(long nowNs) {
    return nowNs - begunNs >= times.occupiedMs() * NS_PER_MS;
  }

  /** Whether the request is to be repeated now. */
  boolean resends(long nowNs) {
    if (nowNs < resendAtNs) {
      return false;
    }
    double longerNs = (double) resendNs * times.backoff();
    resendNs = Math.min((long) longerNs, times.maxResendMs() * NS_PER_MS);
    resendAtNs = nowNs + resendNs;
    resends++;
    return true;
  }

  /** Whether it is time to ask for a later view. */
  boolean wantsNews() {
    return resends % RESENDS_PER_QUERY == 0;
  }

  /**
   * Which of {@code missing}, who are needed from now on at the latest, have been silent too long.
   */
  List<ProcessId> silent(SortedSet<ProcessId> missing, long nowNs) {
    missing.forEach(peer -> suspicion.expect(peer, nowNs));
    return suspicion.suspects(nowNs);
  }

  void heard(ProcessId peer, long nowNs) {
    suspicion.heard(peer, nowNs);
  }

  /** Nothing is needed of anybody else any more. */
  void needsOnly(SortedSet<ProcessId> missing) {
    for (ProcessId peer : suspicion.expected()) {
      if (!missing.contains(peer)) {
        suspicion.release(peer);
      }
    }
  }
}
