package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * Every run of a mutex is a run of a theory that grants sections one by one.
 *
 * <pre>
 * event                       action, where i is the event's robot
 * fact do_mutex               ask(i, the sequence, its ticket); the set in any order, if it is one;
 *                             before it restart(i), if it holds; or withdraw(i), if it asks anew
 * fact od_mutex               grant(i, z) for each section that is new; of a robot that resumes, and whose body has left,
 *                             restart(i), ask and grant of all, and stands_in(i, nothing)
 * fact release                release(i, given), of the newest id; stands_in(i, the rest without given)
 * fact withdraw               withdraw(i), if it waits
 * fact stands_in              stands_in(i, sections)
 * a view without i's id       withdraw(i), if it waits: a removed id has no request
 * fault restart               restart(i); also before a request of a new id, if an older one holds, and
 *                             of an id that was given up and still enters
 * joined                      restart(i), if the robot had left before
 * all others                  none
 * </pre>
 *
 * <p>A ticket is the request's logical time, and among equal times the place of its id.
 *
 * @param <S> the theory's states
 * @param <A> its actions
 */
abstract class GrantConformance<S, A extends Action>
    extends Conformance<GrantConformance.Run<S, A>> {

  /** Number of tickets of one logical time. */
  private static final long PLACES = 1L << 20;

  /** The actions and the state, as the theory names them. */
  interface Theory<S, A> {

    A ask(RobotId i, List<String> sections, long ticket);

    A grant(RobotId i, String section, S state);

    A release(RobotId i, SortedSet<String> given);

    A withdraw(RobotId i);

    A restart(RobotId i);

    A standsIn(RobotId i, SortedSet<String> sections);

    /** What its present program holds. */
    SortedSet<String> crit(RobotId i, S state);

    /** What earlier starts of its program held. */
    SortedSet<String> rest(RobotId i, S state);

    /** What it asked for and was not granted, in the order of the grants. */
    Collection<String> asked(RobotId i, S state);
  }

  private final Theory<S, A> theory;
  private final Set<RobotId> gone = new TreeSet<>();

  GrantConformance(
      String name, String subject, Theory<S, A> theory, Function<Instance, Replay<S, A>> replay) {
    super(name, subject, source -> new Run<>(replay.apply(source)), MutexFact.PRIMITIVE);
    this.theory = theory;
  }

  /** Whether a mutex with this request is replayed, from now on. */
  abstract boolean begins(MutexFact.DoMutex request);

  /** Whether a mutex with this request is not replayed any more. */
  abstract boolean ends(MutexFact.DoMutex request);

  /** One mutex. */
  static final class Run<S, A extends Action> {
    private final Replay<S, A> replay;
    // The id of each robot's newest request, and its ticket.
    private final Map<RobotId, ProcessId> asked = new TreeMap<>();
    private final Map<RobotId, Long> tickets = new TreeMap<>();
    // What each robot waits for, by the facts.
    private final Map<RobotId, SortedSet<String>> waits = new TreeMap<>();
    // What each process holds, by the facts: to ask anew meanwhile is a restart in the theory, so a
    // part of this is in the theory's rest.
    private final Map<ProcessId, SortedSet<String>> holds = new TreeMap<>();
    // The robots whose newest request takes over what an earlier start of the program held.
    private final Set<RobotId> resuming = new TreeSet<>();
    private final Map<Long, TreeMap<ProcessId, Long>> places = new TreeMap<>();
    private long viewNumber;
    private boolean hasBegun;
    private boolean isOver;

    private Run(Replay<S, A> replay) {
      this.replay = replay;
    }

    private boolean isReplayed() {
      return hasBegun && !isOver;
    }

    /** Distinct numbers in the order of (time, id). */
    private long ticket(MutexFact.DoMutex request) {
      TreeMap<ProcessId, Long> equal =
          places.computeIfAbsent(request.ts(), time -> new TreeMap<>());
      Map.Entry<ProcessId, Long> before = equal.lowerEntry(request.who());
      Map.Entry<ProcessId, Long> after = equal.higherEntry(request.who());
      long from = before == null ? 0 : before.getValue();
      long to = after == null ? PLACES : after.getValue();
      equal.put(request.who(), (from + to) / 2);
      return request.ts() * PLACES + (from + to) / 2;
    }
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    switch (event) {
      case Fault fault when fault.name().equals(Fault.RESTART) -> restart(fault, report);
      case TraceEvent.Left left -> gone.add(left.robot());
      case TraceEvent.Joined joined when gone.remove(joined.robot()) -> restart(joined, report);
      default -> {}
    }
  }

  private void restart(TraceEvent event, Report report) {
    instances().values().stream()
        .filter(Run::isReplayed)
        .forEach(run -> run.replay.step(event, theory.restart(event.robot()), report));
  }

  @Override
  protected void acted(TraceEvent.Action action, Report report) {
    if (action.fact() instanceof MutexFact fact) {
      Run<S, A> run = instance(action.source());
      if (fact instanceof MutexFact.DoMutex request) {
        run.hasBegun |= begins(request);
        run.isOver |= ends(request);
      }
      if (run.isReplayed()) {
        acted(run, action, fact, report);
      }
    }
  }

  private boolean isWaiting(Run<S, A> run, RobotId i) {
    return !theory.asked(i, run.replay.state()).isEmpty();
  }

  private SortedSet<String> crit(Run<S, A> run, RobotId i) {
    return theory.crit(i, run.replay.state());
  }

  private SortedSet<String> rest(Run<S, A> run, RobotId i) {
    return theory.rest(i, run.replay.state());
  }

  private void acted(Run<S, A> run, TraceEvent.Action event, MutexFact fact, Report report) {
    RobotId i = fact.who().robot();
    switch (fact) {
      case MutexFact.DoMutex request -> {
        boolean isAnew =
            request.who().equals(run.asked.put(i, request.who()))
                && !run.waits.getOrDefault(i, Sections.NONE).isEmpty();
        if (isAnew && crit(run, i).isEmpty()) {
          run.replay.step(event, theory.withdraw(i), report);
        }
        run.waits.put(
            i, request.sequence().isEmpty() ? request.want() : Sections.copyOf(request.sequence()));
        run.tickets.put(i, run.ticket(request));
        run.resuming.remove(i);
        if (request.resumes()) {
          run.resuming.add(i);
        }
        ask(
            run,
            event,
            request.sequence().isEmpty() ? List.copyOf(request.want()) : request.sequence(),
            report);
      }
      case MutexFact.OdMutex access -> {
        run.holds.put(access.who(), access.held());
        run.waits.computeIfPresent(i, (same, all) -> Sections.without(all, access.held()));
        if (!isWaiting(run, i)) {
          // Its id was given up, and enters what others still leave to it, as if it resumed.
          SortedSet<String> isHeld = Sections.union(crit(run, i), rest(run, i));
          SortedSet<String> more = Sections.without(access.held(), isHeld);
          if (!more.isEmpty()) {
            ask(run, event, List.copyOf(more), report);
          }
        }
        // Others let it go first while it resumed. Its body has left since: in the theory it
        // resumes once more.
        boolean resumesAgain =
            run.resuming.contains(i) && rest(run, i).isEmpty() && !crit(run, i).isEmpty();
        if (resumesAgain) {
          List<String> all = new ArrayList<>(crit(run, i));
          all.addAll(theory.asked(i, run.replay.state()));
          ask(run, event, all, report);
        }
        for (String z : List.copyOf(theory.asked(i, run.replay.state()))) {
          if (access.held().contains(z)) {
            run.replay.step(event, theory.grant(i, z, run.replay.state()), report);
          }
        }
        if (resumesAgain) {
          run.replay.step(event, theory.standsIn(i, Sections.NONE), report);
        }
        if (rest(run, i).isEmpty()) {
          run.replay.result(event, "crit_set", i, access.held(), crit(run, i), report);
        }
      }
      case MutexFact.Release release -> {
        run.holds.put(release.who(), release.left());
        SortedSet<String> rest = rest(run, i);
        if (release.who().equals(run.asked.get(i))) {
          SortedSet<String> given = Sections.common(release.given(), crit(run, i));
          run.replay.step(event, theory.release(i, given), report);
        }
        if (Sections.meet(rest, release.given())) {
          SortedSet<String> left = Sections.without(rest, release.given());
          run.replay.step(event, theory.standsIn(i, left), report);
        }
      }
      case MutexFact.Withdraw end -> {
        run.waits.remove(i);
        if (isWaiting(run, i) && end.who().equals(run.asked.get(i))) {
          run.replay.step(event, theory.withdraw(i), report);
        }
      }
      case MutexFact.StandsIn place -> {
        SortedSet<String> holds = run.holds.getOrDefault(place.who(), Sections.NONE);
        run.replay.step(event, theory.standsIn(i, Sections.union(place.sections(), holds)), report);
      }
      case MutexFact.Learned learned -> learned(run, event, learned.view(), report);
      default -> {
        // The theory has no agreement protocol.
      }
    }
  }

  private void ask(Run<S, A> run, TraceEvent.Action event, List<String> sections, Report report) {
    RobotId i = event.robot();
    if (!crit(run, i).isEmpty()) {
      run.replay.step(event, theory.restart(i), report);
    }
    run.replay.step(event, theory.ask(i, sections, run.tickets.getOrDefault(i, 0L)), report);
  }

  private void learned(Run<S, A> run, TraceEvent.Action event, View view, Report report) {
    if (view.number() <= run.viewNumber) {
      return;
    }
    run.viewNumber = view.number();
    run.asked.forEach((robot, id) -> {
      if (isWaiting(run, robot) && !view.contains(id)) {
        run.replay.step(event, theory.withdraw(robot), report);
      }
    });
  }
}
