package org.starl.primitives.mutex;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.ProtocolAutomaton.Request;
import org.starl.primitives.mutex.ProtocolAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Finite;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Sets;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;

/**
 * Every run of every mutex is a run of the protocol {@code MutexProtocol_decls}: processes that ask those on
 * their lists by messages. A process of the theory is a participant, so a robot has one for each registration.
 *
 * <pre>
 * fact          actions, where i is the participant
 * do_mutex      witness(i, the time before its own), since i hears times in all messages of its robot;
 *               request(i, want, known and all that are removed, whether it is for a sequence)
 * known         known(i, these and all that are removed), if i waits; of these, while it holds
 *               sections, those that it has asked before
 * grant         grant(i, to, its time, z) for each section z that it waits for, if that request is open;
 *               else none: it has no effect. Also a message Ok, the first: a participant that has
 *               retired grants without a fact
 * od_mutex      release(j, what i enters) for earlier participants j of i's robot, whose body it is;
 *               vouch(f, j, i, its time, z) for each j that is removed and whose grant i needs;
 *               enter(i, what it enters)
 * release       release(i, given)
 * withdraw      withdraw(i), if i waits
 * stands_in     withdraw(j), or release(j, all but the sections), for i's earlier starts j
 * view          fence(f, j) for each j that this view has removed: by listed participants f that have fenced
 *               it, and by those of later starts of its robot; forget(i, j) for each j that has left
 * fence         none before the view that removes the suspect
 * </pre>
 *
 * <p>The theory keeps all messages. Here those of a request are dropped when its participant makes the
 * next one. A mutex is replayed until the first request in a mode, or that resumes a sequence after a
 * restart; all are until a process is killed in real time, because the end of its trace may be missing. The
 * report says so.
 */
public final class ProtocolConformance extends Conformance<ProtocolConformance.Run> {

  private boolean isRealTime;
  private boolean isCut;

  public ProtocolConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public ProtocolConformance(AutomatonListener<States, ProtocolAction> steps) {
    super(
        ProtocolAutomaton.MUTEX_PROTOCOL_DECLS,
        "the messages of every mutex",
        source -> new Run(source, steps),
        MutexFact.PRIMITIVE);
  }

  /** A request: its number, and the message. */
  private record Asked(long num, Request message) {}

  /** One mutex. */
  static final class Run {
    private final Replay<States, ProtocolAction> replay;
    // Each participant's newest request.
    private final Map<ProcessId, Asked> requests = new TreeMap<>();
    // Those of which there was a fact.
    private final Set<ProcessId> seen = new TreeSet<>();
    // The view that admitted each, and who has fenced it.
    private final Map<ProcessId, Long> admitted = new TreeMap<>();
    private final Map<ProcessId, Set<ProcessId>> fencedBy = new TreeMap<>();
    private boolean isOver;

    private Run(Instance source, AutomatonListener<States, ProtocolAction> steps) {
      replay = new Replay<>(new ProtocolAutomaton((i, j) -> i.compareTo(j) < 0), source, steps);
    }

    private States state() {
      return replay.state();
    }

    private SortedSet<String> heldBy(ProcessId i) {
      return state().crit_set().at(i);
    }

    /** What it waits for. */
    private SortedSet<String> waiting(ProcessId i) {
      return Sections.without(state().want().at(i), heldBy(i));
    }

    private boolean isNewest(ProcessId i, long num) {
      Asked asked = requests.get(i);
      return asked != null && asked.num == num;
    }

    private boolean isRemoved(ProcessId i) {
      return !state().fencers().at(i).isEmpty();
    }

    /** These, and all that are removed: their lists may be of before. */
    private SortedSet<ProcessId> withRemoved(SortedSet<ProcessId> known) {
      return Sets.union(known, Sets.of(state().fencers().arguments()));
    }

    /** Without the messages of {@code i}'s earlier requests. */
    private States withoutMessages(States s, ProcessId i) {
      return new States(
          s.clock(),
          s.ts(),
          s.want(),
          s.crit_set(),
          s.parts(),
          s.plist(),
          s.heard(),
          Finite.suchThat(each -> !each.asker().equals(i), s.reqs()),
          Finite.suchThat(each -> !each.asker().equals(i), s.oks()),
          s.fencers(),
          Finite.suchThat(each -> !each.asker().equals(i), s.vouched()));
    }

    /** Whether {@code view}, or one before, has removed {@code i}, or {@code i} has left. */
    private boolean isGone(ProcessId i, View view) {
      return !view.contains(i) && admitted.getOrDefault(i, Long.MAX_VALUE) <= view.number();
    }
  }

  @Override
  protected void acted(TraceEvent.Action action, Report report) {
    if (action.fact() instanceof MutexFact fact) {
      Run run = instance(action.source());
      if (fact instanceof MutexFact.DoMutex request && isOther(request)) {
        run.isOver = true;
        ends(
            ProtocolAutomaton.MUTEX_PROTOCOL_DECLS,
            String.format(
                "%s: %s %s at %s",
                action.source(),
                request.who(),
                request.resumes() ? "resumes a sequence" : "asks in a mode",
                Time.text(action.timeNs(), 3)));
      }
      if (isReplayed(run)) {
        new Step(run, action, report).take(fact);
      }
    }
  }

  private boolean isReplayed(Run run) {
    return !run.isOver && !isCut;
  }

  private static boolean isOther(MutexFact.DoMutex request) {
    return request.resumes() || Sections.haveMode(request.want());
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    switch (event) {
      case Sent sent when sent.message() instanceof MutexMessage.Ok ok -> {
        Run run = instance(sent.channel());
        if (isReplayed(run)) {
          SortedSet<String> its = run.state().want().at(ok.to());
          new Step(run, sent, report).grant(ok.from(), ok.to(), ok.num(), ok.granted(its));
        }
      }
      case Fault fault when isRealTime && fault.name().equals(Fault.CRASH) -> {
        isCut = true;
        ends(
            ProtocolAutomaton.MUTEX_PROTOCOL_DECLS,
            "the trace of " + fault.robot() + " is cut off at " + Time.text(fault.timeNs(), 3));
      }
      case Fault fault -> isRealTime |= fault.isRealTime();
      default -> {} // no action
    }
  }

  /** The actions of one fact, or of a message. */
  private record Step(Run run, TraceEvent event, Report report) {

    private void take(ProtocolAction action) {
      run.replay.step(event, action, report);
    }

    void take(MutexFact fact) {
      ProcessId i = fact.who();
      run.seen.add(i);
      switch (fact) {
        case MutexFact.DoMutex request -> request(i, request);
        case MutexFact.Known later -> known(i, run.withRemoved(later.known()));
        case MutexFact.Grant grant -> {
          SortedSet<String> its = run.state().want().at(grant.to());
          grant(i, grant.to(), grant.num(), grant.granted(its));
        }
        case MutexFact.OdMutex access -> enter(i, access.held());
        case MutexFact.Release release -> release(i, release.given());
        case MutexFact.Withdraw end -> {
          if (run.isNewest(i, end.num())) {
            withdraw(i);
          }
        }
        case MutexFact.StandsIn place -> standsIn(i, place.sections());
        case MutexFact.Learned learned -> learned(i, learned.view());
        case MutexFact.Fence fence ->
            run.fencedBy.computeIfAbsent(fence.suspect(), each -> new TreeSet<>()).add(i);
      }
    }

    private void request(ProcessId i, MutexFact.DoMutex request) {
      run.replay.reduce(s -> run.withoutMessages(s, i));
      Request message = new Request(i, request.ts());
      run.requests.put(i, new Asked(request.num(), message));
      if (run.state().clock().at(i) < request.ts() - 1) {
        take(new ProtocolAction.witness(i, request.ts() - 1));
      }
      take(
          new ProtocolAction.request(
              i, request.want(), run.withRemoved(request.known()), !request.sequence().isEmpty()));
      run.replay.result(event, "ts", i, request.ts(), run.state().ts().at(i), report);
    }

    private void known(ProcessId i, SortedSet<ProcessId> list) {
      if (!run.waiting(i).isEmpty()) {
        boolean holds = !run.heldBy(i).isEmpty();
        take(
            new ProtocolAction.known(
                i, holds ? Sets.intersection(list, run.state().plist().at(i)) : list));
      }
    }

    private void grant(ProcessId i, ProcessId to, long num, SortedSet<String> sections) {
      Asked asked = run.requests.get(to);
      if (asked != null && asked.num == num) {
        long at = asked.message.at();
        for (String z : Sections.common(sections, run.waiting(to))) {
          if (!run.state().isGranted(i, to, at, z)) {
            take(new ProtocolAction.grant(i, to, at, z));
          }
        }
      }
    }

    private void enter(ProcessId i, SortedSet<String> held) {
      SortedSet<String> sections = Sections.without(held, run.heldBy(i));
      for (ProcessId earlier : List.copyOf(run.requests.keySet())) {
        if (earlier.robot().equals(i.robot()) && !earlier.equals(i)) {
          release(earlier, sections);
        }
      }
      for (ProcessId j : Sets.union(run.state().plist().at(i), run.state().heard().at(i))) {
        // It may be removed itself, by a view that counts on what it asks for.
        if (!j.equals(i) && run.isRemoved(j)) {
          sections.forEach(z -> vouch(j, i, z));
        }
      }
      take(new ProtocolAction.enter(i, sections));
      run.replay.result(event, "crit_set", i, held, run.heldBy(i), report);
    }

    private void vouch(ProcessId j, ProcessId i, String z) {
      long ts = run.state().ts().at(i);
      if (!run.state().isGranted(j, i, ts, z)) {
        take(new ProtocolAction.vouch(fencer(j, z), j, i, ts, z));
      }
    }

    /** One that knows that {@code j} does not hold this section, if there is one. */
    private ProcessId fencer(ProcessId j, String z) {
      SortedSet<ProcessId> all = run.state().fencers().at(j);
      return all.stream()
          .filter(f -> !run.state().isMayHold(j, f, z))
          .findFirst()
          .orElseGet(() -> all.iterator().next());
    }

    /** Gives back these, as far as {@code i} holds them. */
    private void release(ProcessId i, SortedSet<String> sections) {
      SortedSet<String> given = Sections.common(sections, run.heldBy(i));
      if (!given.isEmpty()) {
        take(new ProtocolAction.release(i, given));
      }
    }

    private void withdraw(ProcessId i) {
      if (!run.waiting(i).isEmpty()) {
        take(new ProtocolAction.withdraw(i));
      }
    }

    private void standsIn(ProcessId i, SortedSet<String> sections) {
      for (ProcessId earlier : List.copyOf(run.requests.keySet())) {
        if (earlier.robot().equals(i.robot()) && earlier.boot() < i.boot()) {
          withdraw(earlier);
          release(earlier, Sections.without(run.state().want().at(earlier), sections));
        }
      }
    }

    private void learned(ProcessId i, View view) {
      run.admitted.putAll(view.admitted());
      // One that was fenced, and that this view removes, may ask for the first time later.
      Set<ProcessId> all = new TreeSet<>(run.requests.keySet());
      all.addAll(run.fencedBy.keySet());
      for (ProcessId j : all) {
        if (run.isGone(j, view)) {
          fencers(j, view).forEach(f -> take(new ProtocolAction.fence(f, j)));
          if (!run.isRemoved(j) && !run.state().isActive(j)) {
            run.requests.remove(j);
          }
        }
      }
      for (ProcessId j : run.state().heard().at(i)) {
        if (run.isGone(j, view) && !run.isRemoved(j)) {
          take(new ProtocolAction.forget(i, j));
        }
      }
    }

    /** Those that grant {@code j} nothing any more, and of which the automaton does not know it yet. */
    private List<ProcessId> fencers(ProcessId j, View view) {
      Set<ProcessId> fencers = new TreeSet<>(run.fencedBy.getOrDefault(j, Set.of()));
      fencers.removeIf(f -> !view.contains(f));
      run.seen.stream()
          .filter(f -> f.robot().equals(j.robot()) && f.boot() > j.boot())
          .forEach(fencers::add);
      fencers.removeAll(run.state().fencers().at(j));
      return List.copyOf(fencers);
    }
  }
}
