package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.suspicion.Suspicion;

/**
 * The leader's work in one term: assigns to each idle robot the nearest room that no robot has
 * searched or is searching, takes the room from a robot that falls silent, and concludes the
 * search. It begins with what all robots report of themselves, so a new leader goes on where the
 * one before stopped. Pure and clock-driven.
 *
 * <p>Safety does not depend on it: two robots in one room only hinder each other.
 */
final class Assigner {

  private static final long NS_PER_S = 1_000_000_000;
  private static final long SILENCE_NS = 6 * NS_PER_S;

  /** After so long a silence a robot is not expected to come back. */
  private static final long DEATH_NS = 60 * NS_PER_S;

  private static final long TAKEN_WITHIN_NS = 10 * NS_PER_S;

  /** How often each robot tries a room while a dead robot may block the only way to it. */
  private static final int TRIES_BESIDE_THE_DEAD = 2;

  /** How often each robot tries a room otherwise: a robot in its way will move on. */
  private static final int TRIES = 8;

  private final House house;
  private final Participants participants;
  private final long term;
  private final Suspicion suspicion = new Suspicion(SILENCE_NS);
  private final Suspicion death = new Suspicion(DEATH_NS);
  private final SortedSet<RobotId> heard = new TreeSet<>();
  private final SortedMap<RobotId, Given> given = new TreeMap<>();
  private int numbers;

  /** A task, when it was assigned, and whether its robot has reported to be at it. */
  private record Given(Report.Task task, long atNs, boolean isTaken) {}

  private record Match(int tries, int distanceMm, RobotId robot, Room room) {}

  Assigner(House house, RobotId me, Participants participants, long term, long nowNs) {
    this.house = house;
    this.participants = participants;
    this.term = term;
    for (RobotId robot : participants) {
      if (!robot.equals(me)) {
        suspicion.expect(anyLife(robot), nowNs);
        death.expect(anyLife(robot), nowNs);
      }
    }
    heard.add(me);
  }

  /** A robot is silent or not whatever its incarnation. */
  private static ProcessId anyLife(RobotId robot) {
    return ProcessId.first(robot, 1);
  }

  long term() {
    return term;
  }

  /** A report of {@code robot} has arrived. */
  void heard(RobotId robot, long nowNs) {
    heard.add(robot);
    suspicion.heard(anyLife(robot), nowNs);
    death.heard(anyLife(robot), nowNs);
  }

  Report.Duty duty() {
    SortedMap<RobotId, Report.Task> tasks = new TreeMap<>();
    given.forEach((robot, what) -> tasks.put(robot, what.task()));
    return new Report.Duty(term, tasks);
  }

  /** Assigns rooms by what the robots report; returns the end of the search, if this is it. */
  Optional<Answer> work(Knowledge known, long nowNs) {
    List<RobotId> up = new ArrayList<>();
    for (RobotId robot : participants) {
      if (!suspicion.suspects(anyLife(robot), nowNs)) {
        if (!heard.contains(robot)) {
          return Optional.empty(); // it may be searching a room
        }
        up.add(robot);
      }
    }
    given.keySet().retainAll(up);
    SortedSet<Integer> busy = new TreeSet<>();
    List<Report> idle = new ArrayList<>();
    for (RobotId robot : up) {
      Report report = known.latest().get(robot);
      if (report != null) {
        followUp(robot, report, known, nowNs);
        busy.add(report.room());
        if (report.isIdle() && report.at().isPresent() && !given.containsKey(robot)) {
          idle.add(report);
        }
      }
    }
    busy.remove(Report.NO_ROOM);
    given.values().forEach(what -> busy.add(what.task().room()));
    List<Room> open = new ArrayList<>();
    for (Room room : house.rooms()) {
      if (room.isEnterable()
          && !known.swept().contains(room.index())
          && !busy.contains(room.index())) {
        open.add(room);
      }
    }
    boolean isIdle = busy.isEmpty() && idle.size() == up.size();
    int limit = death.suspects(nowNs).isEmpty() ? TRIES : TRIES_BESIDE_THE_DEAD;
    assign(matches(idle, open, limit), nowNs);
    return isIdle && given.isEmpty() ? Optional.of(conclusion(known)) : Optional.empty();
  }

  /** A task ends when its room was searched, or its robot gives it up or does something else. */
  private void followUp(RobotId robot, Report report, Knowledge known, long nowNs) {
    Given what = given.get(robot);
    if (what == null) {
      return;
    }
    boolean isLate = nowNs - what.atNs() > TAKEN_WITHIN_NS;
    if (known.swept().contains(what.task().room())) {
      given.remove(robot);
    } else if (report.room() == what.task().room()) {
      given.put(robot, new Given(what.task(), what.atNs(), true));
    } else if (what.isTaken() || !report.isIdle() || isLate) {
      given.remove(robot);
    }
  }

  /** All pairs of an idle robot and an open room, the best first. */
  private List<Match> matches(List<Report> idle, List<Room> open, int limit) {
    List<Match> matches = new ArrayList<>();
    for (Report report : open.isEmpty() ? List.<Report>of() : idle) {
      int[] distances = house.distancesMm(report.at().orElseThrow());
      for (Room room : open) {
        int tries = report.tries().get(room.index());
        if (tries < limit) {
          matches.add(new Match(tries, distances[room.index()], report.from().robot(), room));
        }
      }
    }
    matches.sort(Comparator.comparingInt(Match::tries).thenComparingInt(Match::distanceMm));
    return matches;
  }

  private void assign(List<Match> matches, long nowNs) {
    List<Match> left = new ArrayList<>(matches);
    while (!left.isEmpty()) {
      Match best = left.get(0);
      numbers++;
      Report.Task task = new Report.Task(best.room().index(), numbers);
      given.put(best.robot(), new Given(task, nowNs, false));
      left.removeIf(match ->
          match.robot().equals(best.robot()) || match.room().index() == best.room().index());
    }
  }

  private Answer conclusion(Knowledge known) {
    List<String> left = new ArrayList<>();
    for (Room room : house.rooms()) {
      if (!known.swept().contains(room.index())) {
        left.add(room.name());
      }
    }
    return Answer.nothing(left);
  }
}
