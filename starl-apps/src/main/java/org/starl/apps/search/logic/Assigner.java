package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.suspicion.Suspicion;

/**
 * The leader's work in one term: gives each idle robot the nearest room that nobody has searched and
 * nobody is at, takes it from who falls silent, and concludes. It begins with what everybody tells of
 * itself, so that a new leader goes on where the one before was. Pure and clock-driven.
 *
 * <p>No safety rests on it: two robots in one room are in each other's way, no more.
 */
final class Assigner {

  private static final long NS_PER_MS = 1_000_000;
  private static final long SILENCE_NS = 6_000 * NS_PER_MS;

  /** Who has been silent for so long will not come back, to all appearances. */
  private static final long DEATH_NS = 60_000 * NS_PER_MS;

  private static final long TAKEN_WITHIN_NS = 10_000 * NS_PER_MS;

  /** Beside somebody dead, who may lie in the only way, a room is tried so often by each. */
  private static final int TRIES_BESIDE_THE_DEAD = 2;

  /** Else who is in the way will go on. */
  private static final int TRIES = 8;

  /** Robots of whatever incarnation: silence is of the robot. */
  private static final long ANY_LIFE = 1;

  private final House house;
  private final Participants participants;
  private final long term;
  private final Suspicion suspicion = new Suspicion(SILENCE_NS);
  private final Suspicion death = new Suspicion(DEATH_NS);
  private final SortedSet<RobotId> heard = new TreeSet<>();
  private final SortedMap<RobotId, Given> given = new TreeMap<>();
  private int numbers;

  private record Given(Report.Task task, long atNs, boolean taken) {}

  Assigner(House house, RobotId me, Participants participants, long term, long nowNs) {
    this.house = house;
    this.participants = participants;
    this.term = term;
    for (RobotId robot : participants) {
      if (!robot.equals(me)) {
        suspicion.expects(new ProcessId(robot, ANY_LIFE), nowNs);
        death.expects(new ProcessId(robot, ANY_LIFE), nowNs);
      }
    }
    heard.add(me);
  }

  long term() {
    return term;
  }

  /** A report of {@code robot} has come. */
  void heard(RobotId robot, long nowNs) {
    heard.add(robot);
    suspicion.heard(new ProcessId(robot, ANY_LIFE), nowNs);
    death.heard(new ProcessId(robot, ANY_LIFE), nowNs);
  }

  Report.Duty duty() {
    SortedMap<RobotId, Report.Task> tasks = new TreeMap<>();
    given.forEach((robot, what) -> tasks.put(robot, what.task()));
    return new Report.Duty(term, tasks);
  }

  /** Looks at who is where, and gives rooms; the end of the search, if this is it. */
  Optional<Answer> work(Board board, long nowNs) {
    List<RobotId> up = new ArrayList<>();
    for (RobotId robot : participants) {
      if (!suspicion.suspects(new ProcessId(robot, ANY_LIFE), nowNs)) {
        if (!heard.contains(robot)) {
          return Optional.empty(); // who may be at work somewhere
        }
        up.add(robot);
      }
    }
    given.keySet().removeIf(robot -> !up.contains(robot));
    SortedSet<Integer> busy = new TreeSet<>();
    for (RobotId robot : up) {
      Report report = board.latest().get(robot);
      if (report != null) {
        followUp(robot, report, board, nowNs);
        busy.add(report.room());
      }
    }
    given.values().forEach(what -> busy.add(what.task().room()));
    int limit = death.suspects(nowNs).isEmpty() ? TRIES : TRIES_BESIDE_THE_DEAD;
    List<RobotId> idle = idle(up, board);
    boolean hasHope = giveRooms(idle, openRooms(board, busy), limit, board, nowNs);
    busy.remove(Report.NO_ROOM);
    boolean isOver = !hasHope && busy.isEmpty() && idle.size() == up.size() && given.isEmpty();
    return isOver ? Optional.of(conclusion(board)) : Optional.empty();
  }

  /** A task ends when its room was searched, or its robot has tried, or does something else. */
  private void followUp(RobotId robot, Report report, Board board, long nowNs) {
    Given what = given.get(robot);
    if (what == null) {
      return;
    }
    int room = what.task().room();
    if (board.isSwept(room)) {
      given.remove(robot);
    } else if (report.room() == room) {
      given.put(robot, new Given(what.task(), what.atNs(), true));
    } else if (what.taken() || !report.isIdle() || nowNs - what.atNs() > TAKEN_WITHIN_NS) {
      given.remove(robot);
    }
  }

  private List<RobotId> idle(List<RobotId> up, Board board) {
    List<RobotId> idle = new ArrayList<>();
    for (RobotId robot : up) {
      Report report = board.latest().get(robot);
      if (report != null
          && report.isIdle()
          && report.at().isPresent()
          && !given.containsKey(robot)) {
        idle.add(robot);
      }
    }
    return idle;
  }

  private List<Room> openRooms(Board board, SortedSet<Integer> busy) {
    List<Room> open = new ArrayList<>();
    for (Room room : house.rooms()) {
      int index = room.index();
      if (room.isEnterable() && !board.isSwept(index) && !busy.contains(index)) {
        open.add(room);
      }
    }
    return open;
  }

  private record Match(int tries, int distanceMm, RobotId robot, Room room) {
    boolean isBetterThan(@Nullable Match other) {
      return other == null
          || tries < other.tries
          || (tries == other.tries && distanceMm < other.distanceMm);
    }
  }

  /**
   * Gives rooms, the nearest pair first.
   *
   * @return whether somebody idle has a room left to try
   */
  private boolean giveRooms(
      List<RobotId> idle, List<Room> rooms, int limit, Board board, long nowNs) {
    List<RobotId> robots = new ArrayList<>(idle);
    List<Room> open = new ArrayList<>(rooms);
    SortedMap<RobotId, int[]> distances = new TreeMap<>();
    boolean hasHope = false;
    Match best = best(robots, open, limit, board, distances);
    while (best != null) {
      hasHope = true;
      numbers++;
      given.put(
          best.robot(), new Given(new Report.Task(best.room().index(), numbers), nowNs, false));
      robots.remove(best.robot());
      open.remove(best.room());
      best = best(robots, open, limit, board, distances);
    }
    return hasHope;
  }

  private @Nullable Match best(
      List<RobotId> robots,
      List<Room> open,
      int limit,
      Board board,
      Map<RobotId, int[]> distances) {
    Match best = null;
    for (RobotId robot : robots) {
      Report report = board.latest().get(robot);
      for (Room room : open) {
        int tries = report == null ? limit : report.tries().get(room.index());
        if (report != null && tries < limit && report.at().isPresent()) {
          int[] toRooms =
              distances.computeIfAbsent(robot, id -> house.distancesMm(report.at().get()));
          Match match = new Match(tries, toRooms[room.index()], robot, room);
          best = match.isBetterThan(best) ? match : best;
        }
      }
    }
    return best;
  }

  private Answer conclusion(Board board) {
    List<String> left = new ArrayList<>();
    for (Room room : house.rooms()) {
      if (!board.isSwept(room.index())) {
        left.add(room.name());
      }
    }
    return left.isEmpty() ? new Answer.Nothing() : new Answer.GaveUp(left);
  }
}
