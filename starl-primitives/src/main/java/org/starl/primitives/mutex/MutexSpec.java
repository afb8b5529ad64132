package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Liveness;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.spec.LemmaMonitor;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/**
 * The specification of one mutex instance, over its trace.
 *
 * <ul>
 *   <li>{@code Exclusive} (the paper's {@code Inv_mux_safety}): what participants of two robots
 *       hold is disjoint. A robot that crashed, left or closed its mutex without a release still
 *       holds its sections, since its body may be there, until the robot's next start declares
 *       otherwise.
 *   <li>{@code Promise}: of two participants with open, overlapping requests, one that has the
 *       other's consent comes first.
 *   <li>{@code Connected}: of two participants with open requests in the latest view, one needs the
 *       other's consent.
 *   <li>{@code Kept}: a removed participant holds only its fenced sections.
 *   <li>{@code Complete}: a participant that holds a section was on a list.
 *   <li>{@code Served}, if there are bounds: a request has access, or has ended, within d2; owed
 *       while no participant has held for longer than d1.
 *   <li>{@code NonInterference}, if there are bounds: the same within d3; owed while no other
 *       participant holds, or waits with priority for, a section of the request. (The paper asks
 *       only that none is <em>held</em>. That is too weak: a participant that waits for {A, B}
 *       while another holds A delays a later request for B.)
 * </ul>
 *
 * <p>The last two are owed only while no fault but crashes is active, no ghost is fenced in a
 * wanted section, and no participant is dead whose consent is needed; {@code Served} only while
 * that holds for all waiting requests. They are owed again, with the whole bound, once it holds
 * again, and when the set of participants whose consent is needed changes. A participant that is
 * dead, has left the floor or was removed from the views is owed nothing.
 */
public final class MutexSpec extends LemmaMonitor {

  static final String EXCLUSIVE = "Exclusive";
  static final String PROMISE = "Promise";
  static final String CONNECTED = "Connected";

  static final String KEPT = "Kept";
  static final String COMPLETE = "Complete";

  private final String source;
  private final @Nullable MutexProgress progress;
  private final Requests requests = new Requests();
  private final Liveness liveness = new Liveness();

  // The latest view that any robot has learned, and the ids of all views.
  private View last = View.NONE;
  private final Set<ProcessId> listed = new TreeSet<>();

  /** Checks safety only. */
  public MutexSpec(String xid) {
    this(xid, null);
  }

  /** Checks safety, and also progress if there are bounds. */
  public MutexSpec(String xid, @Nullable MutexBounds bounds) {
    source = MutexTrace.source(xid);
    progress =
        bounds == null ? null : new MutexProgress(bounds, requests, new ProgressAssumptions());
    lemma(EXCLUSIVE, "No two robots hold a section in common.");
    lemma(
        PROMISE, "Of two overlapping requests, the one that has the other's consent comes first.");
    lemma(CONNECTED, "Of two requests by listed processes, one needs the other's consent.");
    lemma(KEPT, "A removed process holds only its fenced sections.");
    lemma(COMPLETE, "A process that holds a section was on the list.");
    if (progress != null) {
      lemma(
          MutexProgress.SERVED,
          "Every request is served within the bound, if no process holds sections for too long.");
      lemma(
          MutexProgress.NON_INTERFERENCE,
          "A request without competing requests is served within its shorter bound.");
    }
  }

  private void progress(Consumer<MutexProgress> step) {
    if (progress != null) {
      step.accept(progress);
    }
  }

  @Override
  public List<String> perRobotLemmas() {
    return List.of(KEPT, COMPLETE);
  }

  @Override
  public List<Monitor> companions() {
    return List.of(new MutexConformance());
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    boolean changes = liveness.observe(event);
    if (changes) {
      progress(p -> {
        p.expire(event.timeNs(), report);
        p.look(event.timeNs());
      });
    }
    if (event instanceof TraceEvent.Action action && action.source().equals(source)) {
      Optional<MutexEvent> read = MutexTrace.read(action);
      if (read.isPresent()) {
        progress(p -> p.expire(action.timeNs(), report));
        happened(read.get(), action.timeNs(), report);
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    progress(p -> p.expire(endNs, report));
  }

  private void happened(MutexEvent event, long nowNs, Report report) {
    Requests.Request request = requests.of(event.who());
    switch (event) {
      case MutexEvent.DoMutex e -> {
        requests.begin(request, e);
        checkConnected(request, nowNs, report);
        checkPromises(request, nowNs, report);
        progress(p -> p.began(request, nowNs));
      }
      case MutexEvent.OdMutex e -> {
        requests.enter(request, e.held());
        checkExclusive(request, nowNs, report);
        checkListed(request, nowNs, report);
        progress(p -> p.entered(request, nowNs, report));
      }
      case MutexEvent.Release e -> {
        requests.shrink(request, e.left());
        progress(p -> p.shrank(request, e.given(), nowNs));
      }
      case MutexEvent.Withdraw e -> withdrew(request, nowNs);
      case MutexEvent.Grant e -> granted(requests.of(e.to()), e, nowNs, report);
      case MutexEvent.Learned e -> learned(e.view(), nowNs, report);
      case MutexEvent.StandsIn e -> standsIn(e, nowNs);
      case MutexEvent.Fence e -> {
        // By itself it changes nothing.
      }
      case MutexEvent.Known e -> {
        request.known = e.known();
        checkConnected(request, nowNs, report);
        progress(p -> p.needsOthers(request, nowNs));
      }
    }
  }

  private void learned(View view, long nowNs, Report report) {
    listed.addAll(view.ids());
    if (view.number() > last.number()) {
      last = view;
      progress(p -> p.look(nowNs));
      for (Requests.Request request : requests.active()) {
        if (request.critical) {
          checkListed(request, nowNs, report);
        }
      }
    }
  }

  /** Earlier starts of the robot's program wait for nothing, and hold at most these sections. */
  private void standsIn(MutexEvent.StandsIn declared, long nowNs) {
    for (Requests.Request request : new ArrayList<>(requests.active())) {
      if (request.who.robot().equals(declared.who().robot())
          && isOfEarlierStart(request, declared)) {
        SortedSet<String> before = request.want;
        requests.shrink(
            request,
            request.critical ? Sections.common(before, declared.sections()) : Sections.NONE);
        progress(p -> p.shrank(request, Sections.without(before, request.want), nowNs));
      }
    }
  }

  private static boolean isOfEarlierStart(Requests.Request request, MutexEvent.StandsIn declared) {
    return request.who.inc() >>> Integer.SIZE < declared.who().inc() >>> Integer.SIZE;
  }

  private void checkListed(Requests.Request holder, long nowNs, Report report) {
    boolean wasListed = listed.contains(holder.who);
    String lemma = wasListed ? KEPT : COMPLETE;
    report.checked(KEPT);
    report.checked(COMPLETE);
    View.Ghost ghost = last.ghost(holder.who);
    SortedSet<String> atMost = ghost == null ? Sections.NONE : ghost.sections();
    if (!last.contains(holder.who) && !atMost.containsAll(holder.want)) {
      report.violated(
          lemma,
          nowNs,
          List.of(holder.who.robot()),
          holder.who
              + " holds "
              + holder.want
              + ", but in view "
              + last
              + " it may hold at most "
              + atMost);
    }
  }

  private void withdrew(Requests.Request request, long nowNs) {
    if (!request.isActive()) {
      return; // failed before it began
    }
    TreeSet<String> wanted = new TreeSet<>(request.want);
    requests.shrink(request, Sections.NONE);
    progress(p -> p.shrank(request, wanted, nowNs));
  }

  private void checkExclusive(Requests.Request entering, long nowNs, Report report) {
    report.checked(EXCLUSIVE);
    for (String section : entering.want) {
      for (Requests.Request other : requests.contendersFor(section)) {
        if (other.critical && !other.who.robot().equals(entering.who.robot())) {
          report.violated(
              EXCLUSIVE,
              nowNs,
              robots(entering.who, other.who),
              entering.who + " and " + other.who + " both hold " + section);
        }
      }
    }
  }

  private void granted(Requests.Request to, MutexEvent.Grant grant, long nowNs, Report report) {
    if (to.isActive() && to.num == grant.num()) {
      Requests.Request by = requests.of(grant.who());
      requests.consent(by, to);
      checkPromise(to, by, nowNs, report);
    }
  }

  private void checkPromises(Requests.Request beginning, long nowNs, Report report) {
    for (Requests.Request to : beginning.consentedTo) {
      checkPromise(to, beginning, nowNs, report);
    }
  }

  private static void checkPromise(
      Requests.Request to, Requests.Request by, long nowNs, Report report) {
    report.checked(PROMISE);
    if (by.isActive() && Sections.meet(to.want, by.want) && !to.isBefore(by)) {
      report.violated(
          PROMISE,
          nowNs,
          robots(to.who, by.who),
          by.who + " consented to " + to + ", but its own " + by + " comes first");
    }
  }

  private void checkConnected(Requests.Request request, long nowNs, Report report) {
    if (!request.isActive() || !last.contains(request.who)) {
      return;
    }
    report.checked(CONNECTED);
    for (Requests.Request other : requests.active()) {
      if (other != request
          && last.contains(other.who)
          && !request.known.contains(other.who)
          && !other.known.contains(request.who)) {
        report.violated(
            CONNECTED,
            nowNs,
            robots(request.who, other.who),
            "neither of " + request.who + " and " + other.who + " needs the other's consent");
      }
    }
  }

  static List<RobotId> robots(ProcessId a, ProcessId b) {
    return List.copyOf(new TreeSet<>(List.of(a.robot(), b.robot())));
  }

  private final class ProgressAssumptions implements MutexProgress.Assumptions {
    @Override
    public boolean isImpeded(Requests.Request request) {
      return !liveness.isFair()
          || request.known.stream().anyMatch(liveness::isDead)
          || last.ghosts().entrySet().stream()
              .anyMatch(ghost ->
                  !ghost.getKey().robot().equals(request.who.robot())
                      && Sections.meet(ghost.getValue().sections(), request.want));
    }

    @Override
    public boolean isOwedNothing(Requests.Request request) {
      return (listed.contains(request.who) && !last.contains(request.who))
          || (liveness.isDead(request.who) && !request.critical);
    }
  }
}
