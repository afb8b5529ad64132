package org.starl.primitives.barrier;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.barrier.BarrierAutomaton.Outcome;
import org.starl.primitives.barrier.BarrierAutomaton.States;
import org.starl.primitives.barrier.BarrierAutomaton.Told;
import org.starl.spec.Monitor.Report;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Steps;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/** The map of {@link BarrierConformance}, for one instance. */
final class BarrierRun {

  /** Who was told that it is left out of a generation whose outcome nobody has told yet. */
  private record Early(Variable event, ProcessId i) {}

  private final BarrierAutomaton automaton;
  private final Replay<States, BarrierAction> replay;
  private final Map<RobotId, ProcessId> ids = new TreeMap<>();
  private final SortedMap<Long, List<Early>> excluded = new TreeMap<>();

  BarrierRun(String source, SortedSet<ProcessId> first, Steps<States, BarrierAction> steps) {
    automaton = new BarrierAutomaton(first);
    replay = new Replay<>(automaton, source, steps);
  }

  void made(Action event, ProcessId i, SortedSet<ProcessId> members, Report report) {
    ids.put(event.robot(), i);
    replay.result(event, "first", i, members, automaton.first(), report);
  }

  void arrives(Action event, long generation, ProcessId i, Report report) {
    if (i.robot().equals(event.robot())) {
      replay.step(event, new BarrierAction.arrive(i, generation), report);
    }
  }

  void shows(Variable event, Report report) {
    switch (BarrierOutcome.parse(event.value())) {
      case BarrierOutcome.Passed all ->
          isTold(event, all.generation(), new Outcome.passed(), report);
      case BarrierOutcome.Failed some ->
          isTold(event, some.generation(), new Outcome.failed(some.missing()), report);
      case BarrierOutcome.Excluded out -> isOut(event, out.generation(), report);
      case BarrierOutcome.NoneYet none -> {
        // A stutter, and so is the other.
      }
      case BarrierOutcome.Unknown open -> {}
    }
  }

  private void isTold(Variable event, long generation, Outcome told, Report report) {
    if (replay.state().isOpen(generation)) {
      decide(event, generation, told, report);
    }
    ProcessId i = ids.get(event.robot());
    if (i == null) {
      Outcome outcome = replay.state().outcome().at(generation);
      replay.result(event, "outcome", generation, told, outcome, report);
    } else {
      tell(event, i, generation, report);
    }
  }

  private void isOut(Variable event, long generation, Report report) {
    ProcessId i = ids.get(event.robot());
    if (i == null || generation == 0) {
      return; // nobody is left out
    }
    if (replay.state().isOpen(generation)) {
      excluded.computeIfAbsent(generation, g -> new ArrayList<>()).add(new Early(event, i));
    } else {
      tell(event, i, generation, report);
    }
  }

  private void decide(TraceEvent event, long generation, Outcome outcome, Report report) {
    replay.step(event, new BarrierAction.decide(generation, outcome), report);
    replay.forget(s -> s.withoutArrivals(generation));
    List<Early> waiting = excluded.remove(generation);
    if (waiting != null) {
      waiting.forEach(early -> tell(early.event, early.i, generation, report));
    }
  }

  private void tell(Variable event, ProcessId i, long generation, Report report) {
    replay.step(event, new BarrierAction.tell(i, generation), report);
    String shown = shown(i, replay.state().told().at(i)).toString();
    replay.result(event, "told", i, event.value(), shown, report);
  }

  private static BarrierOutcome shown(ProcessId i, Told told) {
    return switch (told.out()) {
      case Outcome.open none -> BarrierOutcome.NONE_YET;
      case Outcome.passed all -> new BarrierOutcome.Passed(told.gen());
      case Outcome.failed some when some.missing().contains(i) ->
          new BarrierOutcome.Excluded(told.gen());
      case Outcome.failed some -> new BarrierOutcome.Failed(told.gen(), some.missing());
    };
  }

  /** At the end of the run: of whom those who were told left out, nobody else was told. */
  void finish(Report report) {
    new TreeMap<>(excluded)
        .forEach((generation, waiting) -> {
          SortedSet<ProcessId> out = new TreeSet<>();
          waiting.forEach(early -> out.add(early.i));
          decide(waiting.get(0).event, generation, new Outcome.failed(out), report);
        });
  }
}
