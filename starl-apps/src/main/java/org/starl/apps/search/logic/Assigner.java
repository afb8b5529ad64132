package org.starl.apps.search.logic;

import static org.starl.time.Time.NS_PER_S;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
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

  private static final long SILENCE_NS = 6 * NS_PER_S;

  /** After so long a silence a robot is not expected to come back. */
  private static final long DEATH_NS = 60 * NS_PER_S;

  /** How often each robot tries a room while a dead robot may block the only way to it. */
  private static final int TRIES_BESIDE_THE_DEAD = 2;

  /** How often each robot tries a room otherwise: a robot in its way will move on. */
  private static final int TRIES = 8;

  private final House house;
  private final Participants participants;
  private final long term;
  private final Suspicion suspicion = new Suspicion(SILENCE_NS);
  private final Suspicion death = new Suspicion(DEATH_NS);
  private final Set<RobotId> heard = new TreeSet<>();
  private final SortedMap<RobotId, Report.Task> tasks = new TreeMap<>();

  private record Match(int tries, int distanceMm, RobotId robot, int room) {}

  Assigner(House house, RobotId me, Participants participants, long term, long nowNs) {
    this.house = house;
    this.participants = participants;
    this.term = term;
    for (RobotId robot : participants) {
      if (!robot.equals(me)) {
        suspicion.expect(anyIncarnation(robot), nowNs);
        death.expect(anyIncarnation(robot), nowNs);
      }
    }
    heard.add(me);
  }

  /** A robot is silent or not whatever its incarnation. */
  private static ProcessId anyIncarnation(RobotId robot) {
    return new ProcessId(robot, 1);
  }

  long term() {
    return term;
  }

  /** A report of {@code robot} has arrived. */
  void heard(RobotId robot, long nowNs) {
    heard.add(robot);
    suspicion.heard(anyIncarnation(robot), nowNs);
    death.heard(anyIncarnation(robot), nowNs);
  }

  Report.Duty duty() {
    return new Report.Duty(term, new TreeMap<>(tasks));
  }

  /** Assigns rooms by what the robots report; returns the end of the search, if this is it. */
  Optional<String> work(Knowledge known, long nowNs) {
    SortedMap<RobotId, Report> up = new TreeMap<>(known.latest());
    for (RobotId robot : participants) {
      if (suspicion.suspects(anyIncarnation(robot), nowNs)) {
        up.remove(robot);
      } else if (!heard.contains(robot)) {
        return Optional.empty(); // it may be searching a room
      }
    }
    tasks.keySet().retainAll(up.keySet());
    up.forEach((robot, report) ->
        tasks.computeIfPresent(robot, (same, task) -> isOver(task, report, known) ? null : task));
    Set<Integer> busy =
        up.values().stream().map(Report::room).collect(Collectors.toCollection(TreeSet::new));
    busy.remove(Report.NO_ROOM);
    tasks.values().forEach(task -> busy.add(task.room()));
    List<Report> idle =
        up.values().stream()
            .filter(report -> report.isIdle() && report.at().isPresent())
            .filter(report -> !tasks.containsKey(report.robot()))
            .collect(Collectors.toList());
    boolean isIdle = busy.isEmpty() && idle.size() == up.size();
    List<Room> left = new ArrayList<>(house.rooms());
    left.removeIf(room -> known.swept().contains(room.index()));
    List<Room> open = new ArrayList<>(left);
    open.removeIf(room -> !room.isEnterable() || busy.contains(room.index()));
    assign(matches(idle, open, nowNs));
    return isIdle && tasks.isEmpty() ? Optional.of(Answer.nothing(left)) : Optional.empty();
  }

  /** Whether the room of a task was searched, or its robot has failed to search it or restarted. */
  private static boolean isOver(Report.Task task, Report report, Knowledge known) {
    return known.swept().contains(task.room()) || report.tries().get(task.room()) != task.tries();
  }

  /** All pairs of an idle robot and an open room that the robot may try. */
  private List<Match> matches(List<Report> idle, List<Room> open, long nowNs) {
    int limit = death.suspects(nowNs).isEmpty() ? TRIES : TRIES_BESIDE_THE_DEAD;
    List<Match> matches = new ArrayList<>();
    for (Report report : open.isEmpty() ? List.<Report>of() : idle) {
      int[] distances = house.distancesMm(report.at().orElseThrow());
      for (Room room : open) {
        int tries = report.tries().get(room.index());
        if (tries < limit) {
          matches.add(new Match(tries, distances[room.index()], report.robot(), room.index()));
        }
      }
    }
    return matches;
  }

  private void assign(List<Match> matches) {
    Comparator<Match> order =
        Comparator.comparingInt(Match::tries).thenComparingInt(Match::distanceMm);
    while (!matches.isEmpty()) {
      Match best = matches.stream().min(order).orElseThrow();
      tasks.put(best.robot(), new Report.Task(best.room(), best.tries()));
      matches.removeIf(match -> match.robot().equals(best.robot()) || match.room() == best.room());
    }
  }
}
