package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.spec.TrafficAutomaton.Locations;
import org.starl.apps.intersection.spec.TrafficAutomaton.Position;
import org.starl.apps.intersection.spec.TrafficAutomaton.States;
import org.starl.geometry.Point;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.membership.View;
import org.starl.spec.Bodies;
import org.starl.spec.Monitor.Report;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Replay;
import org.starl.spec.automaton.Sets;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Moved;

/** The replay of {@link TrafficConformance}. */
final class TrafficRun {

  // More than any run lasts, and sums of it are numbers.
  private static final long NEVER_NS = Long.MAX_VALUE / 4;

  private final Replay<States, TrafficAction> replay;
  private final Function<RobotId, List<String>> ways;
  private final Bodies bodies = new Bodies();
  private final Map<RobotId, ProcessId> cars = new TreeMap<>();
  // Those of them whose program has ended: the next one of the robot asks under another id.
  private final Set<ProcessId> restarted = new TreeSet<>();
  private final Set<RobotId> crashed = new TreeSet<>();
  // Those that may not know it, and go on.
  private final Set<ProcessId> givenUpByOthers = new TreeSet<>();
  // The numbers of the views that were shown, and of the lists that they have.
  private final TreeMap<Long, Long> lists = new TreeMap<>();
  private final Map<RobotId, Long> known = new TreeMap<>();
  private long timeNs;

  /**
   * @param ways the zones of each robot's way; none of a robot that is no car
   */
  TrafficRun(Instance intersection, Function<RobotId, List<String>> ways) {
    this.ways = ways;
    TrafficAutomaton automaton =
        new TrafficAutomaton(
            robot -> ways.apply(new RobotId(robot)),
            i -> i.robot().name(),
            NEVER_NS,
            NEVER_NS,
            NEVER_NS,
            NEVER_NS);
    replay = new Replay<>(automaton, intersection, AutomatonListener.none());
  }

  /** Follows the bodies. */
  void observe(TraceEvent event, Report report) {
    bodies.observe(event);
    ProcessId i = event instanceof Moved ? cars.get(event.robot()) : null;
    if (i != null) {
      advance(event, i, report);
    }
  }

  private Locations location(ProcessId i) {
    return replay.state().loc().at(i);
  }

  void crashes(RobotId robot) {
    crashed.add(robot);
  }

  /** What the earlier program knew, the next one has to learn again. */
  void restarts(TraceEvent event, Report report) {
    crashed.remove(event.robot());
    known.remove(event.robot());
    ProcessId i = cars.get(event.robot());
    if (i != null) {
      restarted.add(i);
      if (mayGiveUp(i)) {
        step(event, new TrafficAction.give_up(i), report);
      }
    }
  }

  private boolean mayGiveUp(ProcessId i) {
    return switch (location(i)) {
      case register_wait, mutex_wait, move_wait -> true;
      case away, S0, S1, done, over -> false;
    };
  }

  void standsIn(TraceEvent event, SortedSet<String> sections, Report report) {
    ProcessId i = cars.get(event.robot());
    if (i == null) {
      return;
    }
    boolean isOnRoad = bodies.isOnFloor(event.robot());
    if (!isOnRoad && location(i) == Locations.over && place(i) < ways.apply(i.robot()).size()) {
      step(event, new TrafficAction.towed(i), report);
    }
    step(event, new TrafficAction.stands_in(i, sections), report);
  }

  void registers(TraceEvent event, ProcessId i, Report report) {
    ProcessId before = cars.get(i.robot());
    if (before != null && !mayAskAgain(before)) {
      step(event, new TrafficAction.do_register(before), report);
      return;
    }
    step(
        event,
        before != null && isAmongTheZones(before)
            ? new TrafficAction.restart(i, before)
            : new TrafficAction.arrive(i),
        report);
    cars.put(i.robot(), i);
    step(event, new TrafficAction.do_register(i), report);
    learn(event, i, known.getOrDefault(i.robot(), 0L), report);
  }

  private boolean mayAskAgain(ProcessId i) {
    return switch (location(i)) {
      case register_wait, over -> true;
      default -> restarted.contains(i);
    };
  }

  /** Whether the next process of its car goes on from there. */
  private boolean isAmongTheZones(ProcessId i) {
    boolean hasEnded = !mayGiveUp(i) && location(i) != Locations.S0;
    return hasEnded && (place(i) >= 0 || !replay.state().mux().mux().rest_set().at(i).isEmpty());
  }

  void unregisters(TraceEvent event, ProcessId i, Report report) {
    if (replay.state().reg().gone().contains(i)) {
      return;
    }
    boolean hasAskedForNone = location(i) == Locations.register_wait && isOfRestarted(i);
    step(
        event,
        hasAskedForNone ? new TrafficAction.give_up(i) : new TrafficAction.unregister(i),
        report);
  }

  private boolean isOfRestarted(ProcessId i) {
    return restarted.stream().anyMatch(each -> each.robot().equals(i.robot()));
  }

  /** Returns false if it holds zones, and its program may go on. */
  boolean givesUp(TraceEvent event, ProcessId i, Report report) {
    if (!event.robot().equals(i.robot())) {
      givenUpByOthers.add(i);
    }
    switch (location(i)) {
      case register_wait, mutex_wait -> step(event, new TrafficAction.give_up(i), report);
      case S1 -> step(event, new TrafficAction.unregister(i), report);
      case move_wait -> {
        if (!crashed.contains(i.robot())) {
          return false;
        }
        step(event, new TrafficAction.give_up(i), report);
      }
      case away, S0, done, over -> {
        // It is on no list, or may be left out already.
      }
    }
    return true;
  }

  boolean isGivenUpByOthers(ProcessId i) {
    return givenUpByOthers.contains(i);
  }

  /** A restarted program asks for the zones from the first in which its body may be. */
  void asksFor(TraceEvent event, ProcessId i, SortedSet<String> want, Report report) {
    while (isBehind(i, want) && !replay.hasDeviated()) {
      step(event, new TrafficAction.skip(i), report);
    }
    step(event, new TrafficAction.do_mutex(i, want), report);
  }

  private boolean isBehind(ProcessId i, SortedSet<String> want) {
    List<String> rest = replay.state().myseq().at(i);
    return location(i) == Locations.register_wait
        && replay.state().resumed().contains(i)
        && rest.size() > 1
        && !want.contains(rest.get(0));
  }

  void withdraws(TraceEvent event, ProcessId i, Report report) {
    if (location(i) != Locations.over) {
      step(event, new TrafficAction.withdraw(i), report);
    }
  }

  /** Returns false if the theory has no such list. */
  boolean saw(TraceEvent event, View view, Report report) {
    SortedSet<ProcessId> list = Sets.of(view.admitted().keySet());
    if (lists.isEmpty() || view.number() > lists.lastKey()) {
      if (!list.equals(latest())) {
        step(event, new TrafficAction.decide(list), report);
      }
      lists.put(view.number(), replay.state().reg().number());
    }
    Long number = lists.get(view.number());
    if (number == null) {
      return false;
    }
    known.put(event.robot(), number);
    ProcessId i = cars.get(event.robot());
    if (i != null && !restarted.contains(i)) {
      learn(event, i, number, report);
      replay.result(event, "rList", i, list, replay.state().reg().rList(i), report);
    }
    return true;
  }

  private SortedSet<ProcessId> latest() {
    return replay.state().reg().list().at(replay.state().reg().number());
  }

  private void learn(TraceEvent event, ProcessId i, long number, Report report) {
    if (number > replay.state().reg().ts().at(i)) {
      step(event, new TrafficAction.learn(i, number), report);
    }
  }

  /** A request needs the consent of {@code asked}, some of which may be on later lists alone. */
  void asks(TraceEvent event, ProcessId i, SortedSet<ProcessId> asked, Report report) {
    if (location(i) != Locations.mutex_wait) {
      return; // it has all consents, or asks no more
    }
    SortedSet<ProcessId> list = replay.state().mux().plist().at(i);
    SortedSet<ProcessId> both = Sets.intersection(list, Sets.add(i, asked));
    replay.result(event, "plist", i, both, list, report);
  }

  void holds(TraceEvent event, ProcessId i, SortedSet<String> left, Report report) {
    SortedSet<String> held = replay.state().mux().mux().crit_set().at(i);
    replay.result(event, "crit_set", i, left, held, report);
  }

  /** Takes an action, at the time of the event, when all cars are where their bodies are. */
  void step(TraceEvent event, TrafficAction action, Report report) {
    cars.forEach((robot, i) -> advance(event, i, report));
    pass(event, report);
    replay.step(event, action, report);
  }

  private void pass(TraceEvent event, Report report) {
    if (event.timeNs() > timeNs) {
      replay.step(event, new TrafficAction.dt(event.timeNs() - timeNs), report);
      timeNs = event.timeNs();
    }
  }

  private void advance(TraceEvent event, ProcessId i, Report report) {
    List<String> way = ways.apply(i.robot());
    if (!bodies.isOnFloor(i.robot()) || way.isEmpty() || location(i) == Locations.over) {
      return;
    }
    int at = place(i);
    while (at < target(event, i, way) && !isAhead(i, way) && !replay.hasDeviated()) {
      pass(event, report);
      replay.step(event, new TrafficAction.advance(i), report);
      at++;
    }
  }

  /** Whether it has yet to give back the zone before the one that it is in. */
  private boolean isAhead(ProcessId i, List<String> way) {
    List<String> rest = replay.state().myseq().at(i);
    return place(i) > way.size() - rest.size();
  }

  /** The number of its zone; -1 before the first one. */
  private int place(ProcessId i) {
    List<String> way = ways.apply(i.robot());
    return switch (replay.state().pos().at(i)) {
      case Position.arrival at -> -1;
      case Position.inside at -> way.indexOf(at.zone());
      case Position.departed at -> way.size();
    };
  }

  /** The number of the first zone of its way that its true body is in. */
  private int target(TraceEvent event, ProcessId i, List<String> way) {
    Point at = bodies.poseAt(i.robot(), event.timeNs()).at();
    double radiusMm = bodies.radiusMm(i.robot());
    for (int n = 0; n < way.size(); n++) {
      if (Crossing.region(way.get(n)).distanceMm(at) < radiusMm) {
        return n;
      }
    }
    return place(i) < 0 ? -1 : way.size();
  }
}
