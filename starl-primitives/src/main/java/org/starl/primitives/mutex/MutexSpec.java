package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.ProcessId;
import org.starl.RobotId;
import org.starl.spec.Monitor;
import org.starl.trace.TraceEvent;

/**
 * The specification of one mutex instance, over its trace.
 *
 * <ul>
 *   <li>{@code Exclusive} (the paper's {@code Inv_mux_safety}): what two participants hold is
 *       disjoint. Who crashed, left or closed its mutex without a release holds for ever: its body
 *       may still be there.
 *   <li>{@code Promise}: of two participants with open requests that meet, one that has the other's
 *       consent comes before it.
 *   <li>{@code Connected}: of two participants with open requests, one needs the other's consent.
 *   <li>{@code Served}, if there are bounds: a request has access, or has ended, within d2; owed
 *       while nobody has held for longer than d1.
 *   <li>{@code NonInterference}, if there are bounds: the same within d3; owed while nobody holds,
 *       or waits with priority for, a section of the request. (That nobody <em>holds</em> one, as
 *       printed in the paper, is too little: who waits for {A, B} while another holds A keeps a
 *       later request for B back.)
 * </ul>
 *
 * <p>The last two are owed anew, with their whole bound, when a request comes to need the consent of
 * other participants than before, and are for runs in which everybody in a view is up and within
 * reach. The request of a robot that has left the floor is owed nothing.
 */
public final class MutexSpec implements Monitor {

  static final String EXCLUSIVE = "Exclusive";
  static final String PROMISE = "Promise";
  static final String CONNECTED = "Connected";

  private final String source;
  private final List<String> lemmas = new ArrayList<>(List.of(EXCLUSIVE, PROMISE, CONNECTED));
  private final @Nullable MutexProgress progress;
  private final Requests requests = new Requests();

  /** Safety only. */
  public MutexSpec(String xid) {
    this(xid, null);
  }

  /** Safety, and progress where there are bounds. */
  public MutexSpec(String xid, @Nullable MutexBounds bounds) {
    source = MutexTrace.source(xid);
    progress = bounds == null ? null : new MutexProgress(bounds, requests);
    if (progress != null) {
      lemmas.add(MutexProgress.SERVED);
      lemmas.add(MutexProgress.NON_INTERFERENCE);
    }
  }

  @Override
  public List<String> lemmas() {
    return List.copyOf(lemmas);
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (event instanceof TraceEvent.Left left && progress != null) {
      progress.expire(left.timeNs(), report);
      progress.left(left.robot());
    }
    if (event instanceof TraceEvent.Action action && action.source().equals(source)) {
      Optional<MutexEvent> read = MutexTrace.read(action);
      if (read.isPresent()) {
        if (progress != null) {
          progress.expire(action.timeNs(), report);
        }
        happened(read.get(), action.timeNs(), report);
      }
    }
  }

  @Override
  public void finish(long endNs, Report report) {
    if (progress != null) {
      progress.expire(endNs, report);
    }
  }

  private void happened(MutexEvent event, long nowNs, Report report) {
    Requests.Request request = requests.of(event.who());
    switch (event) {
      case MutexEvent.DoMutex e -> {
        requests.begin(request, e);
        checkConnected(request, nowNs, report);
        checkPromises(request, nowNs, report);
        if (progress != null) {
          progress.began(request, nowNs);
        }
      }
      case MutexEvent.OdMutex e -> {
        requests.enter(request, e.held());
        checkExclusive(request, nowNs, report);
        if (progress != null) {
          progress.entered(request, nowNs, report);
        }
      }
      case MutexEvent.Release e -> {
        requests.shrink(request, e.left());
        if (progress != null) {
          progress.shrank(request, e.given(), nowNs);
        }
      }
      case MutexEvent.Withdraw e -> withdrew(request, nowNs);
      case MutexEvent.Grant e -> granted(requests.of(e.to()), e, nowNs, report);
      case MutexEvent.Known e -> {
        request.known = e.known();
        checkConnected(request, nowNs, report);
        if (progress != null) {
          progress.needsOthers(request, nowNs);
        }
      }
    }
  }

  private void withdrew(Requests.Request request, long nowNs) {
    if (!request.isActive()) {
      return; // failed before it began
    }
    TreeSet<String> wanted = new TreeSet<>(request.want);
    requests.shrink(request, Sections.NONE);
    if (progress != null) {
      progress.shrank(request, wanted, nowNs);
    }
  }

  private void checkExclusive(Requests.Request entering, long nowNs, Report report) {
    report.checked(EXCLUSIVE);
    for (String section : entering.want) {
      for (Requests.Request other : requests.contendersFor(section)) {
        if (other != entering && other.critical) {
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
          by.who + " consented to " + to + " and comes before it with " + by);
    }
  }

  private void checkConnected(Requests.Request request, long nowNs, Report report) {
    if (!request.isActive()) {
      return;
    }
    report.checked(CONNECTED);
    for (Requests.Request other : requests.active()) {
      if (other != request
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
}
