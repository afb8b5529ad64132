package org.starl.primitives.mutex;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Liveness;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.spec.FaultState;
import org.starl.spec.Monitor.Report;

/** The part of {@link MutexSpec} for one instance: its requests, their consents and its views. */
final class MutexRecord {

  private static final long USUAL_DEADLINE_NS = MutexTimes.DEFAULT.deadlineMs() * NS_PER_MS;

  private final @Nullable MutexBounds bounds;
  private final List<MutexProgress> progress = new ArrayList<>();
  private final Requests requests = new Requests();
  private final Liveness liveness;
  private final String capacity;

  // The latest view that any robot has learned, and the ids of all views.
  private View last = View.NONE;
  // The latest view that each robot has learned.
  private final Map<RobotId, View> latest = new TreeMap<>();
  private boolean isCalm = true;
  private final boolean hasCalmBounds;
  private final Set<ProcessId> fenced = new TreeSet<>();
  private final Set<ProcessId> listed = new TreeSet<>();

  /**
   * @param bounds null to check safety only
   * @param calm the bounds of a calm world, if they are to be checked
   * @param liveness of the run, which the specification keeps
   * @param capacity the lemma of the number of robots in a section
   */
  MutexRecord(
      @Nullable MutexBounds bounds,
      @Nullable MutexBounds calm,
      Liveness liveness,
      String capacity) {
    this.capacity = capacity;
    this.bounds = bounds;
    this.liveness = liveness;
    this.hasCalmBounds = calm != null;
    if (bounds != null) {
      progress.add(new MutexProgress(bounds, requests, new ProgressAssumptions(liveness::isFair)));
    }
    if (calm != null) {
      progress.add(new MutexProgress(calm, requests, new ProgressAssumptions(() -> isCalm)));
    }
  }

  private void progress(Consumer<MutexProgress> step) {
    progress.forEach(step);
  }

  /** A robot or a fault has begun or ended. */
  void livenessChanged(long nowNs, Report report) {
    expire(nowNs, report);
    isCalm = liveness.isCalm(nowNs, FaultState.SETTLE_NS);
    progress(p -> p.look(nowNs));
  }

  /** Reports what was due before {@code nowNs}. */
  void expire(long nowNs, Report report) {
    progress(p -> p.expire(nowNs, report));
    if (isCalm != liveness.isCalm(nowNs, FaultState.SETTLE_NS)) {
      isCalm = !isCalm;
      progress(p -> p.look(nowNs));
    }
  }

  /** Checks an event of this instance. */
  void happened(MutexFact event, long nowNs, Report report) {
    Requests.Request request = requests.of(event.who());
    switch (event) {
      case MutexFact.DoMutex e -> {
        requests.begin(request, e, nowNs);
        checkConnected(request, nowNs, report);
        checkPromises(request, nowNs, report);
        progress(p -> p.began(request, nowNs));
      }
      case MutexFact.OdMutex e -> {
        requests.enter(request, e.held());
        checkExclusive(request, nowNs, report);
        checkListed(request, nowNs, report);
        progress(p -> p.entered(request, nowNs, report));
      }
      case MutexFact.Release e -> {
        requests.shrink(request, Sections.without(request.want, e.given()));
        progress(p -> p.shrank(request, e.given(), nowNs));
      }
      case MutexFact.Withdraw e -> withdrew(request, e.why(), nowNs, report);
      case MutexFact.Grant e -> granted(requests.of(e.to()), e, nowNs, report);
      case MutexFact.Learned e -> {
        latest.put(e.who().robot(), e.view());
        learned(e.view(), nowNs, report);
      }
      case MutexFact.StandsIn e -> standsIn(e, nowNs);
      case MutexFact.Fence e -> {
        checkSuspicion(e, nowNs, report);
        progress(p -> p.look(nowNs));
      }
      case MutexFact.Known e -> {
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
        if (request.holds()) {
          checkListed(request, nowNs, report);
        }
      }
    }
  }

  /** Earlier starts of the robot's program wait for nothing, and hold at most these sections. */
  private void standsIn(MutexFact.StandsIn declared, long nowNs) {
    for (Requests.Request request : new ArrayList<>(requests.active())) {
      if (request.who.robot().equals(declared.who().robot())
          && isOfEarlierStart(request, declared)) {
        SortedSet<String> before = request.want;
        requests.shrink(request, Sections.common(request.held, declared.sections()));
        progress(p -> p.shrank(request, Sections.without(before, request.want), nowNs));
      }
    }
  }

  private static boolean isOfEarlierStart(Requests.Request request, MutexFact.StandsIn declared) {
    return request.who.boot() < declared.who().boot();
  }

  private void checkListed(Requests.Request holder, long nowNs, Report report) {
    boolean wasListed = listed.contains(holder.who);
    String lemma = wasListed ? MutexSpec.KEPT : MutexSpec.COMPLETE;
    report.checked(MutexSpec.KEPT);
    report.checked(MutexSpec.COMPLETE);
    SortedSet<String> atMost = asGhost(holder.who);
    if (!last.contains(holder.who) && !atMost.containsAll(holder.held)) {
      report.violated(
          lemma,
          nowNs,
          List.of(holder.who.robot()),
          String.format(
              "%s holds %s, but in view %s it may hold at most %s",
              holder.who, holder.held, last, atMost));
    }
  }

  private SortedSet<String> asGhost(ProcessId who) {
    View.Ghost ghost = last.ghost(who);
    return ghost == null ? Sections.NONE : ghost.sections();
  }

  /** The sections that it may still enter: a removed process enters only what its ghost has. */
  private SortedSet<String> mayGet(Requests.Request request) {
    boolean isRemoved = listed.contains(request.who) && !last.contains(request.who);
    return isRemoved ? Sections.common(request.want, asGhost(request.who)) : request.want;
  }

  private void withdrew(Requests.Request request, MutexFailure why, long nowNs, Report report) {
    if (!request.isActive()) {
      return; // failed before it began
    }
    checkReason(request, why, nowNs, report);
    SortedSet<String> wanted = Sections.without(request.want, request.held);
    requests.shrink(request, request.held);
    progress(p -> p.shrank(request, wanted, nowNs));
  }

  private void checkReason(Requests.Request request, MutexFailure why, long nowNs, Report report) {
    long waitedNs = nowNs - request.begunNs;
    View known = latest.getOrDefault(request.who.robot(), View.NONE);
    boolean isEarly =
        why == MutexFailure.DEADLINE
            && bounds != null
            && waitedNs < Math.min(bounds.d2Ns(), USUAL_DEADLINE_NS / 2);
    boolean isFree = why == MutexFailure.OCCUPIED && !hasGhostInTheWay(known, request);
    if (isEarly || isFree) {
      String told = " was told " + why + " after " + waitedNs / NS_PER_MS + " ms";
      report.checked(MutexProgress.SERVED);
      report.violated(
          MutexProgress.SERVED,
          nowNs,
          List.of(request.who.robot()),
          request + told + (isFree ? ", but no ghost is in its way" : ", before d2"));
    }
  }

  /** In a calm world a process that answers is not suspected: the first fence is a suspicion. */
  private void checkSuspicion(MutexFact.Fence fence, long nowNs, Report report) {
    boolean isFirst = fenced.add(fence.suspect());
    if (hasCalmBounds && isFirst && isCalm && !liveness.isDead(fence.suspect())) {
      report.checked(MutexProgress.SERVED);
      report.violated(
          MutexProgress.SERVED,
          nowNs,
          robots(fence.who(), fence.suspect()),
          fence.who() + " fences " + fence.suspect() + ", which is up, in a calm world");
    }
  }

  private static boolean hasGhostInTheWay(View view, Requests.Request request) {
    return view.ghosts().entrySet().stream()
        .anyMatch(ghost ->
            !ghost.getKey().robot().equals(request.who.robot())
                && Sections.compete(ghost.getValue().sections(), request.want));
  }

  private void checkExclusive(Requests.Request entering, long nowNs, Report report) {
    report.checked(MutexSpec.EXCLUSIVE);
    if (capacity.equals(MutexSpec.CAPACITY)) {
      report.checked(capacity);
    }
    for (String section : entering.held) {
      Set<RobotId> sharing = new TreeSet<>(Set.of(entering.who.robot()));
      for (Requests.Request other : requests.contendersFor(section)) {
        if (other.held.contains(section)) {
          sharing.add(other.who.robot());
        }
        if (Sections.exclude(other.held, List.of(section))
            && !other.who.robot().equals(entering.who.robot())) {
          report.violated(
              MutexSpec.EXCLUSIVE,
              nowNs,
              robots(entering.who, other.who),
              entering.who + " and " + other.who + " both hold " + section);
        }
      }
      if (sharing.size() > Sections.capacity(section) && Sections.capacity(section) > 1) {
        report.violated(
            capacity,
            nowNs,
            List.copyOf(sharing),
            entering.who + " is in " + section + " together with all of " + sharing);
      }
    }
  }

  private void granted(Requests.Request to, MutexFact.Grant grant, long nowNs, Report report) {
    if (to.isActive() && to.num == grant.num()) {
      Requests.Request by = requests.of(grant.who());
      requests.consent(by, to, grant.granted(to.want));
      checkPromise(to, by, nowNs, report);
    }
  }

  private void checkPromises(Requests.Request beginning, long nowNs, Report report) {
    for (Requests.Request to : beginning.consentedTo.keySet()) {
      checkPromise(to, beginning, nowNs, report);
    }
  }

  private void checkPromise(Requests.Request to, Requests.Request by, long nowNs, Report report) {
    report.checked(MutexSpec.PROMISE);
    SortedSet<String> promised =
        Sections.common(mayGet(to), by.consentedTo.getOrDefault(to, Sections.NONE));
    // What it holds already, it may hold by a view without the one that consents.
    boolean isOutOfOrder =
        Sections.exclude(Sections.without(promised, to.held), by.want)
            && !to.resumes
            && !by.resumes
            && !to.isBefore(by);
    if (isOutOfOrder || Sections.exclude(promised, by.held)) {
      report.violated(
          MutexSpec.PROMISE,
          nowNs,
          robots(to.who, by.who),
          by.who + " consented to " + to + ", but its own " + by + " comes first");
    }
  }

  private void checkConnected(Requests.Request request, long nowNs, Report report) {
    if (!request.isActive() || !last.contains(request.who)) {
      return;
    }
    report.checked(MutexSpec.CONNECTED);
    for (Requests.Request other : requests.active()) {
      if (other != request
          && last.contains(other.who)
          && !request.known.contains(other.who)
          && !other.known.contains(request.who)) {
        report.violated(
            MutexSpec.CONNECTED,
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
    private final BooleanSupplier isFair;

    ProgressAssumptions(BooleanSupplier isFair) {
      this.isFair = isFair;
    }

    @Override
    public boolean isImpeded(Requests.Request request) {
      return !isFair.getAsBoolean()
          || fenced.contains(request.who)
          || request.known.stream().anyMatch(liveness::isDead)
          || (request.inOrder && !last.ghosts().isEmpty())
          || hasGhostInTheWay(last, request);
    }

    @Override
    public boolean isDead(Requests.Request request) {
      return liveness.isDead(request.who);
    }

    @Override
    public boolean isOwedNothing(Requests.Request request) {
      return (listed.contains(request.who) && !last.contains(request.who))
          || (liveness.isDead(request.who) && !request.holds());
    }
  }
}
