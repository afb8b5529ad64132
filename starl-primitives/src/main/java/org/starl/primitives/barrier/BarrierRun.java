package org.starl.primitives.barrier;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.BarrierAutomaton.Outcome;
import org.starl.primitives.barrier.BarrierAutomaton.States;
import org.starl.primitives.barrier.BarrierAutomaton.Told;
import org.starl.spec.Monitor.Report;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Replay;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** The map of {@link BarrierConformance}, for one instance. */
final class BarrierRun {

  /** An id that was told that it is excluded, before the outcome of the generation is known. */
  private record Early(Variable event, ProcessId i) {}

  /** The automaton with its parameter, and the replay on it. */
  private record Begun(BarrierAutomaton automaton, Replay<States, BarrierAction> replay) {

    States state() {
      return replay.state();
    }

    void step(TraceEvent event, BarrierAction action, Report report) {
      replay.step(event, action, report);
    }
  }

  private final String source;
  private final AutomatonListener<States, BarrierAction> steps;
  private final Map<RobotId, ProcessId> ids = new TreeMap<>();
  private final SortedMap<Long, List<Early>> excluded = new TreeMap<>();
  private @Nullable Begun begun;

  BarrierRun(String source, AutomatonListener<States, BarrierAction> steps) {
    this.source = source;
    this.steps = steps;
  }

  void created(Action event, ProcessId i, SortedSet<ProcessId> members, Report report) {
    ids.put(event.robot(), i);
    Begun run = begun;
    if (run == null) {
      BarrierAutomaton automaton = new BarrierAutomaton(members);
      run = new Begun(automaton, new Replay<>(automaton, source, steps));
      begun = run;
    }
    run.replay.result(event, "first", i, members, run.automaton.first(), report);
  }

  void arrived(Action event, long generation, ProcessId i, Report report) {
    Begun run = begun;
    if (run != null && i.robot().equals(event.robot())) {
      run.step(event, new BarrierAction.arrive(i, generation), report);
    }
  }

  void shown(Variable event, Report report) {
    Begun run = begun;
    if (run == null) {
      return;
    }
    switch (BarrierOutcome.parse(event.value())) {
      case BarrierOutcome.Passed o ->
          told(run, event, o.generation(), new Outcome.passed(), report);
      case BarrierOutcome.Failed o ->
          told(run, event, o.generation(), new Outcome.failed(o.missing()), report);
      case BarrierOutcome.Excluded o -> excluded(run, event, o.generation(), report);
      case BarrierOutcome.NoneYet o -> {
        // No action.
      }
      case BarrierOutcome.Unknown o -> {
        // No action.
      }
    }
  }

  private void told(Begun run, Variable event, long generation, Outcome outcome, Report report) {
    if (isOpen(generation, run.state())) {
      decide(run, event, generation, outcome, report);
    }
    ProcessId i = ids.get(event.robot());
    if (i == null) {
      Outcome expected = run.state().outcome().at(generation);
      run.replay.result(event, "outcome", generation, outcome, expected, report);
    } else {
      tell(run, event, i, generation, report);
    }
  }

  private static boolean isOpen(long generation, States s) {
    return s.outcome().at(generation) instanceof Outcome.open;
  }

  /** Without the arrivals in a decided generation, which no action reads. */
  private static States withoutArrivals(long generation, States s) {
    return new States(
        s.arrived().with(generation, s.arrived().defaultValue()), s.outcome(), s.told());
  }

  private void excluded(Begun run, Variable event, long generation, Report report) {
    ProcessId i = ids.get(event.robot());
    if (i == null || generation == 0) {
      return; // it was never a member
    }
    if (isOpen(generation, run.state())) {
      excluded.computeIfAbsent(generation, g -> new ArrayList<>()).add(new Early(event, i));
    } else {
      tell(run, event, i, generation, report);
    }
  }

  private void decide(
      Begun run, TraceEvent event, long generation, Outcome outcome, Report report) {
    run.step(event, new BarrierAction.decide(generation, outcome), report);
    run.replay.reduce(s -> withoutArrivals(generation, s));
    List<Early> waiting = excluded.remove(generation);
    if (waiting != null) {
      waiting.forEach(early -> tell(run, early.event, early.i, generation, report));
    }
  }

  private static void tell(Begun run, Variable event, ProcessId i, long generation, Report report) {
    run.step(event, new BarrierAction.tell(i, generation), report);
    String expected = shown(i, run.state().told().at(i)).toString();
    run.replay.result(event, "told", i, event.value(), expected, report);
  }

  private static BarrierOutcome shown(ProcessId i, Told told) {
    return switch (told.out()) {
      case Outcome.open o -> BarrierOutcome.NONE_YET;
      case Outcome.passed o -> new BarrierOutcome.Passed(told.gen());
      case Outcome.failed o when o.missing().contains(i) -> new BarrierOutcome.Excluded(told.gen());
      case Outcome.failed o -> new BarrierOutcome.Failed(told.gen(), o.missing());
    };
  }

  /** At the end of the run: the excluded ids of an unknown outcome are those that were told so. */
  void finish(Report report) {
    Begun run = begun;
    if (run == null) {
      return;
    }
    new TreeMap<>(excluded)
        .forEach((generation, waiting) -> {
          SortedSet<ProcessId> missing = new TreeSet<>();
          waiting.forEach(early -> missing.add(early.i));
          decide(run, waiting.get(0).event, generation, new Outcome.failed(missing), report);
        });
  }
}
