package org.starl.primitives.registration;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
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

  /** Nobody lags so many views behind; older lists are forgotten, and not compared. */
  private static final int KEPT_VIEWS = 256;

  /** What a robot's present program is and knows. */
  private static final class Program {
    private @Nullable ProcessId id;
    private long knows;
    private boolean isLater;
  }

  /** What waits until the list of its number is decided. */
  private interface Waiting {
    void go(Report report);
  }

  /** A list that somebody knows, and that is not decided yet. */
  private static final class Early {
    private final TraceEvent event;
    private final SortedSet<ProcessId> list;
    private final List<Waiting> waiting = new ArrayList<>();

    Early(TraceEvent event, SortedSet<ProcessId> list) {
      this.event = event;
      this.list = list;
    }
  }

  private final Replay<States, RegistrationAction> replay;
  private final Map<RobotId, Program> programs = new TreeMap<>();
  private final TreeMap<Long, Early> early = new TreeMap<>();

  RegistrationRun(Replay<States, RegistrationAction> replay) {
    this.replay = replay;
  }

  void step(TraceEvent event, RegistrationAction action, Report report) {
    replay.step(event, action, report);
  }

  void isGiven(TraceEvent event, View first, Report report) {
    Program program = program(event.robot());
    for (ProcessId id : first.ids()) {
      if (!replay.state().asked().at(id)) {
        step(event, new RegistrationAction.do_register(id), report);
      }
      if (id.robot().equals(event.robot()) && !program.isLater) {
        program.id = id;
      }
    }
  }

  void asks(TraceEvent event, ProcessId id, Report report) {
    if (!id.robot().equals(event.robot())) {
      return; // nobody asks for another robot
    }
    step(event, new RegistrationAction.do_register(id), report);
    Program program = program(event.robot());
    program.id = id;
    long knows = program.knows;
    if (knows > 0) {
      when(knows, later -> step(event, new RegistrationAction.learn(id, knows), later), report);
    }
  }

  void unregisters(TraceEvent event, ProcessId id, Report report) {
    if (id.robot().equals(event.robot())) {
      step(event, new RegistrationAction.unregister(id), report);
    }
  }

  void givesUp(TraceEvent event, ProcessId id, Report report) {
    if (id.robot().equals(event.robot()) && replay.state().asked().at(id)) {
      step(event, new RegistrationAction.give_up(id), report);
    }
  }

  void sees(Variable event, View view, Report report) {
    if (view.number() == 0) {
      // The first value: a program begins.
      Program begins = new Program();
      begins.isLater = programs.containsKey(event.robot());
      programs.put(event.robot(), begins);
      return;
    }
    Program program = program(event.robot());
    program.knows = view.number();
    SortedSet<ProcessId> list =
        Collections.unmodifiableSortedSet(new TreeSet<>(view.admitted().keySet()));
    if (view.number() > replay.state().number() && !replay.isOver()) {
      early.computeIfAbsent(view.number(), number -> new Early(event, list));
      decide(report);
      if (early.size() > KEPT_VIEWS) {
        fillOne(report);
      }
    }
    learns(event, program.id, view.number(), list, report);
  }

  void shows(Variable event, Report report) {
    String text = event.value();
    int colon = text.indexOf(':');
    ProcessId id = colon < 0 ? null : program(event.robot()).id;
    if (id != null) {
      long number = Long.parseLong(text.substring(0, colon));
      when(
          number,
          later -> {
            replay.result(event, "ts", id, number, replay.state().ts().at(id), later);
            String shown = shown(replay.state().rList(id), number);
            replay.result(event, "rList", id, text, shown, later);
          },
          report);
    }
  }

  /** At the end of the run: whatever waits for views that nobody has known waits no longer. */
  void finish(Report report) {
    while (!early.isEmpty() && !replay.isOver()) {
      fillOne(report);
    }
  }

  private static String shown(SortedSet<ProcessId> list, long number) {
    Set<RobotId> robots = new TreeSet<>();
    list.forEach(member -> robots.add(member.robot()));
    return new RList.Agreed(Participants.of(robots), number).toString();
  }

  private void learns(
      TraceEvent event,
      @Nullable ProcessId id,
      long number,
      SortedSet<ProcessId> recorded,
      Report report) {
    when(
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

  private void when(long number, Waiting what, Report report) {
    Early ahead = early.get(number);
    if (ahead == null) {
      what.go(report);
    } else {
      ahead.waiting.add(what);
    }
  }

  /** The numbers below the first that is known too early are taken to be as the one before them. */
  private void fillOne(Report report) {
    TraceEvent event = early.firstEntry().getValue().event;
    while (replay.state().number() + 1 < early.firstKey() && !replay.isOver()) {
      step(event, new RegistrationAction.decide(replay.state().latest()), report);
    }
    decide(report);
  }

  private void decide(Report report) {
    while (!early.isEmpty() && early.firstKey() == replay.state().number() + 1) {
      Early next = early.pollFirstEntry().getValue();
      step(next.event, new RegistrationAction.decide(next.list), report);
      next.waiting.forEach(waiting -> waiting.go(report));
      replay.forget(s -> s.withoutList(s.number() - KEPT_VIEWS));
      if (replay.isOver()) {
        early.clear();
      }
    }
  }

  private boolean isForgotten(long number) {
    return number <= replay.state().number() - KEPT_VIEWS;
  }

  private Program program(RobotId robot) {
    return programs.computeIfAbsent(robot, name -> new Program());
  }
}
