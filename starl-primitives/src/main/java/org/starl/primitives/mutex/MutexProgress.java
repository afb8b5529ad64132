package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.Requests.Request;
import org.starl.spec.Monitor.Report;
import org.starl.spec.Within;

/**
 * The progress part of {@link MutexSpec}: deadlines of requests, and which request waits for which.
 */
final class MutexProgress {

  static final String SERVED = "mutex.Served";
  static final String NON_INTERFERENCE = "mutex.NonInterference";

  /** The assumptions of progress that do not depend on the requests. */
  interface Assumptions {

    /** Whether a crash, a ghost or a fault may delay the request. */
    boolean isImpeded(Request request);

    /** Whether it need not be granted: its participant is dead or removed, and nobody waits for it. */
    boolean isOwedNothing(Request request);

    /** Whether its participant is dead: it is owed nothing, even if it keeps others waiting. */
    boolean isDead(Request request);
  }

  private final Requests requests;
  private final Assumptions assumptions;
  private final Within<Request> holding;
  private final Within<Request> served;
  private final Within<Request> undisturbed;
  // Requests that have held for longer than d1; while there is one, no request is owed access.
  private final Set<Request> overdue = new LinkedHashSet<>();
  // For each waiting request, those that hold, or wait with priority for, one of its sections.
  private final Map<Request, Set<Request>> ahead = new LinkedHashMap<>();
  // Waiting requests that are impeded; while there is one, it may delay others.
  private final Set<Request> impeded = new LinkedHashSet<>();

  MutexProgress(MutexBounds bounds, Requests requests, Assumptions assumptions) {
    this.requests = requests;
    this.assumptions = assumptions;
    holding = new Within<>(bounds.d1Ns());
    served = new Within<>(bounds.d2Ns());
    undisturbed = new Within<>(bounds.d3Ns());
  }

  /** Reports the requests whose access was due before {@code nowNs}. */
  void expire(long nowNs, Report report) {
    holding.expire(
        nowNs,
        (holder, sinceNs, deadlineNs) -> {
          if (overdue.isEmpty()) {
            expire(served, SERVED, deadlineNs, report);
            ahead.keySet().forEach(request -> served.assume(request, false, deadlineNs));
          }
          overdue.add(holder);
        });
    expire(served, SERVED, nowNs, report);
    expire(undisturbed, NON_INTERFERENCE, nowNs, report);
  }

  private static void expire(Within<Request> deadlines, String lemma, long nowNs, Report report) {
    deadlines.expire(
        nowNs,
        (request, sinceNs, deadlineNs) -> {
          report.checked(lemma);
          report.overdue(
              lemma,
              deadlineNs,
              List.of(request.who.robot()),
              request
                  + " has no access "
                  + deadlines.boundNs() / NS_PER_MS
                  + " ms after it was due");
        });
  }

  void began(Request request, long nowNs) {
    Set<Request> before = new LinkedHashSet<>();
    for (Request other : contenders(request, request.want)) {
      if (other.holds() || other.isBefore(request)) {
        before.add(other);
      } else {
        standsBefore(request, other, nowNs);
      }
    }
    ahead.put(request, before);
    served.start(request, nowNs);
    undisturbed.start(request, nowNs);
    assumeAnew(request, nowNs);
    look(nowNs);
  }

  /** Updates all assumptions after a change of views, faults or needed consents. */
  void look(long nowNs) {
    for (Request request : new ArrayList<>(ahead.keySet())) {
      if (assumptions.isDead(request) || assumptions.isOwedNothing(request)) {
        ahead.remove(request);
        settle(request);
      }
    }
    ahead.values().forEach(before -> before.removeIf(assumptions::isOwedNothing));
    overdue.removeIf(assumptions::isOwedNothing);
    for (Request request : requests.active()) {
      if (assumptions.isOwedNothing(request)) {
        holding.stop(request);
      }
    }
    impeded.clear();
    for (Request request : ahead.keySet()) {
      if (assumptions.isImpeded(request)) {
        impeded.add(request);
      }
    }
    assumeAll(nowNs);
  }

  private void assumeAll(long nowNs) {
    boolean mayBeServed = overdue.isEmpty() && impeded.isEmpty();
    ahead.forEach((request, before) -> {
      served.assume(request, mayBeServed, nowNs);
      undisturbed.assume(request, before.isEmpty() && !impeded.contains(request), nowNs);
    });
  }

  void entered(Request request, long nowNs, Report report) {
    if (request.hasAll()) {
      if (ahead.remove(request) != null) {
        report.checked(SERVED);
        report.checked(NON_INTERFERENCE);
      }
      settle(request);
      unimpede(request, nowNs);
    }
    holding.start(request, nowNs);
    for (Request other : contenders(request, request.want)) {
      standsBefore(request, other, nowNs);
    }
  }

  /** The request no longer holds, or waits for, {@code given}. */
  void shrank(Request request, Collection<String> given, long nowNs) {
    for (Request other : contenders(request, given)) {
      Set<Request> before = ahead.get(other);
      if (before != null && !Sections.compete(request.want, other.want) && before.remove(request)) {
        undisturbed.assume(other, before.isEmpty() && !impeded.contains(other), nowNs);
      }
    }
    if (!request.isActive()) {
      ahead.remove(request);
      settle(request);
      holding.stop(request);
      unimpede(request, nowNs);
      if (overdue.remove(request)) {
        assumeAll(nowNs);
      }
    }
  }

  /** The participants whose consent the request needs have changed. */
  void needsOthers(Request request, long nowNs) {
    if (ahead.containsKey(request)) {
      assumeAnew(request, nowNs);
      look(nowNs);
    }
  }

  private void unimpede(Request request, long nowNs) {
    if (impeded.remove(request)) {
      assumeAll(nowNs);
    }
  }

  /** {@code first} holds, or waits with priority for, a section that {@code other} wants. */
  private void standsBefore(Request first, Request other, long nowNs) {
    Set<Request> before = ahead.get(other);
    if (before != null && before.add(first)) {
      undisturbed.assume(other, false, nowNs);
    }
  }

  private void assumeAnew(Request request, long nowNs) {
    served.assume(request, false, nowNs);
    undisturbed.assume(request, false, nowNs);
    assumeAll(nowNs);
  }

  private void settle(Request request) {
    served.stop(request);
    undisturbed.stop(request);
  }

  private Set<Request> contenders(Request request, Collection<String> sections) {
    Set<Request> all = new LinkedHashSet<>();
    for (String section : sections) {
      all.addAll(requests.contendersFor(section));
    }
    all.remove(request);
    all.removeIf(assumptions::isOwedNothing);
    return all;
  }
}
