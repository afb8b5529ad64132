package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.primitives.mutex.PipelineAutomaton.States;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.spec.automaton.Replay;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Fault;

/**
 * Every run of every mutex with sequences is a run of the theory {@code Pipeline_decls}. A mutex
 * without them is left to {@link MutexConformance}.
 *
 * <pre>
 * event                       action, where i is the event's robot
 * fact do_mutex               do_sequence(i, the sequence, its ticket); the set in any order, if it is one
 * fact od_mutex               grant(i, z) for each section that is new
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
 */
public final class PipelineConformance extends Conformance<PipelineConformance.Run> {

  /** Number of tickets of one logical time. */
  private static final long PLACES = 1L << 20;

  private final Set<RobotId> gone = new TreeSet<>();

  public PipelineConformance() {
    this(AutomatonListener.none());
  }

  /**
   * @param steps receives every step of every instance
   */
  public PipelineConformance(AutomatonListener<States, PipelineAction> steps) {
    super(
        PipelineAutomaton.PIPELINE_DECLS,
        "every mutex with sequences",
        MutexFact::isMutex,
        source -> new Run(source, steps));
  }

  /** One mutex. */
  static final class Run {
    private final Replay<States, PipelineAction> replay;
    // The id of each robot's newest request.
    private final Map<RobotId, ProcessId> asked = new TreeMap<>();
    private final Map<Long, TreeMap<ProcessId, Long>> places = new TreeMap<>();
    private long viewNumber;
    private boolean hasSequences;

    private Run(Instance source, AutomatonListener<States, PipelineAction> steps) {
      replay = new Replay<>(new PipelineAutomaton(), source, steps);
    }

    private boolean isWaiting(RobotId i) {
      return replay.state().isWaits(i);
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
        .filter(run -> run.hasSequences)
        .forEach(run -> run.replay.step(event, new PipelineAction.restart(event.robot()), report));
  }

  @Override
  protected void acted(TraceEvent.Action action, Report report) {
    if (action.fact() instanceof MutexFact fact) {
      Run run = instance(action.source());
      run.hasSequences |=
          fact instanceof MutexFact.DoMutex request && !request.sequence().isEmpty();
      if (run.hasSequences) {
        acted(run, action, fact, report);
      }
    }
  }

  private void acted(Run run, TraceEvent.Action event, MutexFact fact, Report report) {
    RobotId i = fact.who().robot();
    switch (fact) {
      case MutexFact.DoMutex request -> requested(run, event, request, report);
      case MutexFact.OdMutex access -> {
        if (!run.isWaiting(i)) {
          // Its id was given up, and enters what others still leave to it, as if it resumed.
          SortedSet<String> rest = Sections.without(access.held(), run.replay.state().held(i));
          ask(run, event, i, List.copyOf(rest), run.replay.state().ticket().at(i), report);
        }
        for (String z : List.copyOf(run.replay.state().req().at(i))) {
          if (access.held().contains(z)) {
            run.replay.step(event, new PipelineAction.grant(i, z), report);
          }
        }
        if (run.replay.state().rest_set().at(i).isEmpty()) {
          run.replay.result(
              event, "crit_set", i, access.held(), run.replay.state().crit_set().at(i), report);
        }
      }
      case MutexFact.Release release -> {
        SortedSet<String> rest = run.replay.state().rest_set().at(i);
        if (release.who().equals(run.asked.get(i))) {
          SortedSet<String> given =
              Sections.common(release.given(), run.replay.state().crit_set().at(i));
          run.replay.step(event, new PipelineAction.release(i, given), report);
        }
        if (Sections.meet(rest, release.given())) {
          SortedSet<String> left = Sections.without(rest, release.given());
          run.replay.step(event, new PipelineAction.stands_in(i, left), report);
        }
      }
      case MutexFact.Withdraw end -> {
        if (run.isWaiting(i) && end.who().equals(run.asked.get(i))) {
          run.replay.step(event, new PipelineAction.withdraw(i), report);
        }
      }
      case MutexFact.StandsIn place ->
          run.replay.step(event, new PipelineAction.stands_in(i, place.sections()), report);
      case MutexFact.Learned learned -> learned(run, event, learned.view(), report);
      default -> {
        // The theory has no agreement protocol.
      }
    }
  }

  private static void requested(
      Run run, TraceEvent.Action event, MutexFact.DoMutex request, Report report) {
    RobotId i = request.who().robot();
    List<String> sequence =
        request.sequence().isEmpty() ? new ArrayList<>(request.want()) : request.sequence();
    run.asked.put(i, request.who());
    ask(run, event, i, sequence, run.ticket(request), report);
  }

  private static void ask(
      Run run,
      TraceEvent.Action event,
      RobotId i,
      List<String> sequence,
      long ticket,
      Report report) {
    if (!run.replay.state().crit_set().at(i).isEmpty()) {
      run.replay.step(event, new PipelineAction.restart(i), report);
    }
    run.replay.step(event, new PipelineAction.do_sequence(i, sequence, ticket), report);
  }

  private static void learned(Run run, TraceEvent.Action event, View view, Report report) {
    if (view.number() <= run.viewNumber) {
      return;
    }
    run.viewNumber = view.number();
    run.asked.forEach((robot, id) -> {
      if (run.isWaiting(robot) && !view.contains(id)) {
        run.replay.step(event, new PipelineAction.withdraw(robot), report);
      }
    });
  }
}
