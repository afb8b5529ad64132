package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.View;
import org.starl.primitives.registration.RegistrationAutomaton.States;
import org.starl.spec.Monitor.Report;
import org.starl.spec.automaton.Replay;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/** The map of {@link RegistrationConformance}, for one instance. */
final class RegistrationRun {

  /** Older lists are forgotten and not compared: no robot is so many views behind. */
  private static final int KEPT_VIEWS = 256;

  /** Such a gap is no gap: a robot without a key took the number from a changed message. */
  private static final int MOST_MISSING = 10_000;

  /** The present start of a robot's program: its id, and the latest view it knows. */
  private static final class Program {
    private @Nullable ProcessId id;
    private long knows;
    private SortedSet<ProcessId> list = Collections.emptySortedSet();
  }

  /** A list that a robot has shown before the lists of all lower numbers are decided. */
  private record Early(
      TraceEvent event, SortedSet<ProcessId> list, List<Consumer<Report>> waiting) {}

  private final Replay<States, RegistrationAction> replay;
  private final Map<RobotId, Program> programs = new TreeMap<>();
  private final TreeMap<Long, Early> early = new TreeMap<>();

  RegistrationRun(Replay<States, RegistrationAction> replay) {
    this.replay = replay;
  }

  void step(TraceEvent event, RegistrationAction action, Report report) {
    replay.step(event, action, report);
  }

  void asked(TraceEvent event, ProcessId id, Report report) {
    if (!id.robot().equals(event.robot())) {
      return; // a robot asks only for its own ids
    }
    step(event, new RegistrationAction.do_register(id), report);
    Program program = program(event.robot());
    program.id = id;
    long knows = program.knows;
    SortedSet<ProcessId> list = program.list;
    if (knows > 0) {
      onceDecided(
          knows,
          later -> {
            step(event, new RegistrationAction.learn(id, knows), later);
            if (!isForgotten(knows)) {
              replay.result(event, "rList", id, list, replay.state().rList(id), later);
            }
          },
          report);
    }
  }

  void unregistered(TraceEvent event, ProcessId id, Report report) {
    if (id.robot().equals(event.robot())) {
      step(event, new RegistrationAction.unregister(id), report);
    }
  }

  void gaveUp(TraceEvent event, ProcessId id, Report report) {
    if (id.robot().equals(event.robot()) && replay.state().asked().contains(id)) {
      step(event, new RegistrationAction.give_up(id), report);
      replay.result(event, "gone", id, true, replay.state().gone().contains(id), report);
    }
  }

  void saw(Variable event, View view, Report report) {
    if (view.number() == 0) {
      // The first value: the program has started.
      programs.put(event.robot(), new Program());
      return;
    }
    Program program = program(event.robot());
    program.knows = view.number();
    SortedSet<ProcessId> list =
        Collections.unmodifiableSortedSet(new TreeSet<>(view.admitted().keySet()));
    program.list = list;
    if (view.number() > replay.state().number() && !replay.hasDeviated()) {
      early.computeIfAbsent(view.number(), number -> new Early(event, list, new ArrayList<>()));
      decide(report);
      if (early.size() > KEPT_VIEWS) {
        fillOne(report);
      }
    }
    learn(event, program.id, view.number(), list, report);
  }

  void showed(Variable event, RList.Agreed shown, Report report) {
    ProcessId id = program(event.robot()).id;
    if (id != null) {
      long number = shown.ts();
      onceDecided(
          number,
          later -> {
            replay.result(event, "ts", id, number, replay.state().ts().at(id), later);
            RList decided = decided(replay.state().rList(id), number);
            replay.<RList>result(event, "rList", id, shown, decided, later);
          },
          report);
    }
  }

  /** At the end of the run: no view waits any longer for numbers that no robot has shown. */
  void finish(Report report) {
    while (!early.isEmpty() && !replay.hasDeviated()) {
      fillOne(report);
    }
  }

  private static RList decided(SortedSet<ProcessId> list, long number) {
    Set<RobotId> robots = new TreeSet<>();
    list.forEach(member -> robots.add(member.robot()));
    return new RList.Agreed(Participants.of(robots), number);
  }

  private void learn(
      TraceEvent event,
      @Nullable ProcessId id,
      long number,
      SortedSet<ProcessId> recorded,
      Report report) {
    onceDecided(
        number,
        later -> {
          if (isForgotten(number)) {
            return;
          }
          if (id == null) {
            SortedSet<ProcessId> decided = replay.state().list().at(number);
            replay.result(event, "list", number, recorded, decided, later);
          } else {
            step(event, new RegistrationAction.learn(id, number), later);
            replay.result(event, "rList", id, recorded, replay.state().rList(id), later);
          }
        },
        report);
  }

  /** Runs {@code check} now, or when the list of {@code number} is decided. */
  private void onceDecided(long number, Consumer<Report> check, Report report) {
    Early ahead = early.get(number);
    if (ahead == null) {
      check.accept(report);
    } else {
      ahead.waiting.add(check);
    }
  }

  /** Below the first list that is waiting, each missing number is taken to repeat the list before. */
  private void fillOne(Report report) {
    TraceEvent event = early.firstEntry().getValue().event;
    long next = replay.state().number() + 1;
    if (early.firstKey() > next + MOST_MISSING) {
      replay.result(event, "number", event.robot(), early.firstKey(), next, report);
    }
    while (replay.state().number() + 1 < early.firstKey() && !replay.hasDeviated()) {
      step(event, new RegistrationAction.decide(latest(replay.state())), report);
    }
    decide(report);
  }

  private void decide(Report report) {
    while (!early.isEmpty() && early.firstKey() == replay.state().number() + 1) {
      Early next = early.pollFirstEntry().getValue();
      step(next.event, new RegistrationAction.decide(next.list), report);
      next.waiting.forEach(check -> check.accept(report));
      replay.reduce(s -> withoutList(s.number() - KEPT_VIEWS, s));
      if (replay.hasDeviated()) {
        early.clear();
      }
    }
  }

  private static SortedSet<ProcessId> latest(States s) {
    return s.list().at(s.number());
  }

  /** Without an old list, which no step reads. */
  private static States withoutList(long old, States s) {
    return new States(
        s.asked(),
        s.gone(),
        s.entered(),
        s.number(),
        s.list().with(old, s.list().defaultValue()),
        s.ts());
  }

  private boolean isForgotten(long number) {
    return number <= replay.state().number() - KEPT_VIEWS;
  }

  private Program program(RobotId robot) {
    return programs.computeIfAbsent(robot, name -> new Program());
  }
}
