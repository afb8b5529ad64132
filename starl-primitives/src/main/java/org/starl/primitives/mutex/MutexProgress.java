package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.starl.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.Requests.Request;
import org.starl.spec.Monitor.Report;
import org.starl.spec.Within;

/** The timed half of {@link MutexSpec}: who is owed access, and who stands in whose way. */
final class MutexProgress {

  static final String SERVED = "Served";
  static final String NON_INTERFERENCE = "NonInterference";

  private static final long NS_PER_MS = 1_000_000;

  private final Requests requests;
  private final Within<Request> holding;
  private final Within<Request> served;
  private final Within<Request> undisturbed;
  // Who has held for longer than d1; while there is one, nobody is owed to be served.
  private final Set<Request> overdue = new LinkedHashSet<>();
  // For each request that waits: who holds, or waits with priority for, one of its sections.
  private final Map<Request, Set<Request>> ahead = new LinkedHashMap<>();

  MutexProgress(MutexBounds bounds, Requests requests) {
    this.requests = requests;
    holding = new Within<>(bounds.d1Ns());
    served = new Within<>(bounds.d2Ns());
    undisturbed = new Within<>(bounds.d3Ns());
  }

  /** Reports what was owed before {@code nowNs} and did not come. */
  void expire(long nowNs, Report report) {
    boolean noneOverdue = overdue.isEmpty();
    List<Long> deadlinesNs = new ArrayList<>();
    holding.expire(
        nowNs,
        (holder, sinceNs, deadlineNs) -> {
          overdue.add(holder);
          deadlinesNs.add(deadlineNs);
        });
    if (noneOverdue && !deadlinesNs.isEmpty()) {
      long firstNs = deadlinesNs.get(0);
      expire(served, SERVED, firstNs, report);
      ahead.keySet().forEach(request -> served.assume(request, false, firstNs));
    }
    expire(served, SERVED, nowNs, report);
    expire(undisturbed, NON_INTERFERENCE, nowNs, report);
  }

  private static void expire(Within<Request> debts, String lemma, long nowNs, Report report) {
    debts.expire(
        nowNs,
        (request, sinceNs, deadlineNs) -> {
          report.checked(lemma);
          report.violated(
              lemma,
              deadlineNs,
              List.of(request.who.robot()),
              request + " had no access " + debts.boundNs() / NS_PER_MS + " ms after it was owed");
        });
  }

  void began(Request request, long nowNs) {
    Set<Request> before = new LinkedHashSet<>();
    for (Request other : contenders(request, request.want)) {
      if (other.critical || other.isBefore(request)) {
        before.add(other);
      } else {
        standsBefore(request, other, nowNs);
      }
    }
    ahead.put(request, before);
    served.owe(request, nowNs);
    undisturbed.owe(request, nowNs);
    assumeAnew(request, nowNs);
  }

  void entered(Request request, long nowNs, Report report) {
    if (ahead.remove(request) != null) {
      report.checked(SERVED);
      report.checked(NON_INTERFERENCE);
    }
    settle(request);
    holding.owe(request, nowNs);
    for (Request other : contenders(request, request.want)) {
      standsBefore(request, other, nowNs);
    }
  }

  /** It gave back, or no longer waits for, {@code given}. */
  void shrank(Request request, Collection<String> given, long nowNs) {
    for (Request other : contenders(request, given)) {
      Set<Request> before = ahead.get(other);
      if (before != null && !Sections.meet(request.want, other.want) && before.remove(request)) {
        undisturbed.assume(other, before.isEmpty(), nowNs);
      }
    }
    if (!request.isActive()) {
      ahead.remove(request);
      settle(request);
      holding.settle(request);
      if (overdue.remove(request) && overdue.isEmpty()) {
        ahead.keySet().forEach(waiting -> served.assume(waiting, true, nowNs));
      }
    }
  }

  /** It needs other participants' consent than before. */
  void needsOthers(Request request, long nowNs) {
    if (ahead.containsKey(request)) {
      assumeAnew(request, nowNs);
    }
  }

  void left(RobotId robot) {
    for (Request request : ahead.keySet()) {
      if (request.who.robot().equals(robot)) {
        settle(request);
      }
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
    served.assume(request, overdue.isEmpty(), nowNs);
    undisturbed.assume(request, false, nowNs);
    undisturbed.assume(request, ahead.getOrDefault(request, Set.of()).isEmpty(), nowNs);
  }

  private void settle(Request request) {
    served.settle(request);
    undisturbed.settle(request);
  }

  private Set<Request> contenders(Request request, Collection<String> sections) {
    Set<Request> all = new LinkedHashSet<>();
    for (String section : sections) {
      all.addAll(requests.contendersFor(section));
    }
    all.remove(request);
    return all;
  }
}
