package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.primitives.suspicion.Suspicion;

/** The timers of one waiting request: its repetitions, suspicions and deadline. */
final class RequestTimers {

  /** Repetitions between queries for a later view, since a silent participant may have left. */
  private static final int RESENDS_PER_QUERY = 4;

  private final MutexTimes times;
  private final Suspicion suspicion;
  private long begunNs;
  private long deadlineNs = Long.MAX_VALUE;
  private long resendAtNs = Long.MAX_VALUE;
  private long resendNs;
  private int resends;

  RequestTimers(MutexTimes times) {
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

  /** Ends the deadline: a process that holds a part of its sequence goes on waiting. */
  void endDeadline() {
    deadlineNs = Long.MAX_VALUE;
  }

  /** Whether to give up if only a ghost blocks the request. */
  boolean isGhostTimeOver(long nowNs) {
    return nowNs - begunNs >= times.occupiedMs() * NS_PER_MS;
  }

  /** Whether the request must be repeated now; then computes the next repetition. */
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

  /** Whether to ask for a later view now. */
  boolean isQueryDue() {
    return resends % RESENDS_PER_QUERY == 0;
  }

  /** The participants of {@code missing} that have been silent for too long. */
  List<ProcessId> silent(SortedSet<ProcessId> missing, long nowNs) {
    missing.forEach(peer -> suspicion.expect(peer, nowNs));
    return suspicion.suspects(nowNs);
  }

  void heard(ProcessId peer, long nowNs) {
    suspicion.heard(peer, nowNs);
  }

  /** Ends the suspicion of all participants except {@code missing}. */
  void needsOnly(SortedSet<ProcessId> missing) {
    for (ProcessId peer : suspicion.expected()) {
      if (!missing.contains(peer)) {
        suspicion.release(peer);
      }
    }
  }
}
