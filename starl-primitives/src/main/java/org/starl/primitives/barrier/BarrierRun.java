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
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** The map of {@link BarrierConformance}, for one instance. */
final class BarrierRun {

  /** An id that was told that it is excluded, before the outcome of the generation is known. */
  private record Early(Variable event, ProcessId i, BarrierOutcome shown) {}

  /** The automaton with its parameter, and the replay on it. */
  private record Begun(BarrierAutomaton automaton, Replay<States, BarrierAction> replay) {

    States state() {
      return replay.state();
    }

    void step(TraceEvent event, BarrierAction action, Report report) {
      replay.step(event, action, report);
    }
  }

  private final Instance source;
  private final AutomatonListener<States, BarrierAction> steps;
  private final Map<RobotId, ProcessId> ids = new TreeMap<>();
  private final SortedMap<Long, List<Early>> excluded = new TreeMap<>();
  private @Nullable Begun begun;

  BarrierRun(Instance source, AutomatonListener<States, BarrierAction> steps) {
    this.source = source;
    this.steps = steps;
  }

  void created(Action event, BarrierFact.Created created, Report report) {
    ids.put(event.robot(), created.i());
    Begun run = begun;
    if (run == null) {
      BarrierAutomaton automaton = new BarrierAutomaton(created.members());
      run = new Begun(automaton, new Replay<>(automaton, source, steps));
      begun = run;
    }
    run.replay.result(
        event, "first", created.i(), created.members(), run.automaton.first(), report);
  }

  void stepped(Action event, BarrierAction action, Report report) {
    Begun run = begun;
    if (run != null) {
      run.step(event, action, report);
    }
  }

  void shown(Variable event, BarrierOutcome shown, Report report) {
    Begun run = begun;
    if (run == null) {
      return;
    }
    switch (shown) {
      case BarrierOutcome.Passed o ->
          told(run, event, o, o.generation(), new Outcome.passed(), report);
      case BarrierOutcome.Failed o ->
          told(run, event, o, o.generation(), new Outcome.failed(o.missing()), report);
      case BarrierOutcome.Excluded o -> excluded(run, event, o, report);
      case BarrierOutcome.NoneYet o -> {
        // No action.
      }
      case BarrierOutcome.Unknown o -> {
        // No action.
      }
    }
  }

  private void told(
      Begun run,
      Variable event,
      BarrierOutcome shown,
      long generation,
      Outcome outcome,
      Report report) {
    if (isOpen(generation, run.state())) {
      decide(run, event, generation, outcome, report);
    }
    ProcessId i = ids.get(event.robot());
    if (i == null) {
      Outcome expected = run.state().outcome().at(generation);
      run.replay.result(event, "outcome", generation, outcome, expected, report);
    } else {
      tell(run, event, i, generation, shown, report);
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

  private void excluded(Begun run, Variable event, BarrierOutcome.Excluded shown, Report report) {
    long generation = shown.generation();
    ProcessId i = ids.get(event.robot());
    if (i == null || generation == 0) {
      return; // it was never a member
    }
    if (isOpen(generation, run.state())) {
      excluded.computeIfAbsent(generation, g -> new ArrayList<>()).add(new Early(event, i, shown));
    } else {
      tell(run, event, i, generation, shown, report);
    }
  }

  private void decide(
      Begun run, TraceEvent event, long generation, Outcome outcome, Report report) {
    run.step(event, new BarrierAction.decide(generation, outcome), report);
    run.replay.reduce(s -> withoutArrivals(generation, s));
    List<Early> waiting = excluded.remove(generation);
    if (waiting != null) {
      waiting.forEach(early -> tell(run, early.event, early.i, generation, early.shown, report));
    }
  }

  private static void tell(
      Begun run,
      Variable event,
      ProcessId i,
      long generation,
      BarrierOutcome shown,
      Report report) {
    run.step(event, new BarrierAction.tell(i, generation), report);
    run.replay.result(event, "told", i, shown, shown(i, run.state().told().at(i)), report);
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
