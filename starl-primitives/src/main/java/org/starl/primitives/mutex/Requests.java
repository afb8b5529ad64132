package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Sections;

/** The open requests of one mutex, read from its trace. */
final class Requests {

  /** The latest request of one participant. Compared by identity. */
  static final class Request {
    final ProcessId who;
    long num;
    long ts;
    long begunNs;
    boolean inOrder;
    boolean resumes;
    // What it holds, and what it holds or waits for.
    SortedSet<String> held = Sections.NONE;
    SortedSet<String> want = Sections.NONE;
    SortedSet<ProcessId> known = Collections.emptySortedSet();
    // The open requests that this participant consented to, and those that consented to this one,
    // each with the sections.
    final Map<Request, SortedSet<String>> consentedTo = new LinkedHashMap<>();
    final Set<Request> consentedBy = new LinkedHashSet<>();

    private Request(ProcessId who) {
      this.who = who;
    }

    boolean holds() {
      return !held.isEmpty();
    }

    /** Whether it has all that it requested. */
    boolean hasAll() {
      return held.equals(want);
    }

    /** Whether it waits or holds. */
    boolean isActive() {
      return !want.isEmpty();
    }

    boolean isBefore(Request other) {
      return MutexProtocol.isBefore(ts, who, other.ts, other.who);
    }

    @Override
    public String toString() {
      return who + "'s request " + num + " for " + want + " at " + ts;
    }
  }

  private static final int LEAST_SWEEP = 512;

  private final Map<ProcessId, Request> latest = new TreeMap<>();
  private int sweepAt = LEAST_SWEEP;
  private final Set<Request> active = new LinkedHashSet<>();
  // By place: names of one place may share it, or not.
  private final Map<String, Set<Request>> contenders = new LinkedHashMap<>();

  Request of(ProcessId who) {
    if (latest.size() >= sweepAt) {
      // An idle record without consents to open requests equals a new one.
      latest.values().removeIf(r -> !r.isActive() && r.consentedTo.isEmpty());
      sweepAt = Math.max(LEAST_SWEEP, 2 * latest.size());
    }
    return latest.computeIfAbsent(who, Request::new);
  }

  /** The requests that wait or hold. */
  Collection<Request> active() {
    return Collections.unmodifiableSet(active);
  }

  /** The requests that compete for {@code section}, or hold something that does. */
  List<Request> contendersFor(String section) {
    List<Request> all = new ArrayList<>(contenders.getOrDefault(Sections.place(section), Set.of()));
    all.removeIf(each -> !Sections.compete(each.want, List.of(section)));
    return all;
  }

  void begin(Request request, MutexFact.DoMutex event, long nowNs) {
    wants(request, event.want());
    request.begunNs = nowNs;
    request.num = event.num();
    request.ts = event.ts();
    request.inOrder = !event.sequence().isEmpty();
    request.resumes = event.resumes();
    // What it holds at this time is of the same sequence: it asks anew for the rest.
    request.held = Sections.common(request.held, event.want());
    for (Request by : request.consentedBy) {
      by.consentedTo.computeIfPresent(
          request, (same, sections) -> Sections.common(sections, request.held));
    }
    request.known = event.known();
  }

  void enter(Request request, SortedSet<String> held) {
    request.held = held;
    if (!request.inOrder) {
      wants(request, held);
    }
  }

  /** Reduces a request to {@code left}; it ends if nothing is left. */
  void shrink(Request request, SortedSet<String> left) {
    wants(request, left);
    request.held = Sections.common(request.held, left);
    if (left.isEmpty()) {
      for (Request by : request.consentedBy) {
        by.consentedTo.remove(request);
      }
      request.consentedBy.clear();
    }
  }

  void consent(Request by, Request to, SortedSet<String> sections) {
    to.consentedBy.add(by);
    by.consentedTo.merge(to, sections, Sections::union);
  }

  private void wants(Request request, SortedSet<String> now) {
    for (String section : Sections.without(request.want, now)) {
      Set<Request> others = contenders.getOrDefault(Sections.place(section), Set.of());
      others.remove(request);
      if (others.isEmpty()) {
        contenders.remove(Sections.place(section));
      }
    }
    for (String section : now) {
      contenders
          .computeIfAbsent(Sections.place(section), place -> new LinkedHashSet<>())
          .add(request);
    }
    request.want = now;
    if (now.isEmpty()) {
      active.remove(request);
    } else {
      active.add(request);
    }
  }
}
