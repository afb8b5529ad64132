package org.starl.apps.search.logic;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import org.starl.geometry.Point;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/**
 * All that a robot has to say, complete in itself: a newer one replaces an older one, so that losses,
 * doubles and overtaking do no harm. Rooms by their numbers.
 *
 * @param from this incarnation of the robot
 * @param number grows from report to report of an incarnation
 * @param at where the robot is, if it knows
 * @param room that it is searching or on its way to, or {@link #NO_ROOM}
 * @param seen what it knows to have been seen of that room, as {@link Runs}
 * @param swept rooms that were searched in full, whoever did it
 * @param tries how often this incarnation has tried each room in vain
 * @param duty what the robot wants others to do, if it leads
 * @param answer what it believes to be the end, or knows
 */
record Report(
    ProcessId from,
    long number,
    Optional<Point> at,
    int room,
    List<Integer> seen,
    SortedSet<Integer> swept,
    List<Integer> tries,
    Optional<Duty> duty,
    Optional<Answer> answer) {

  static final int NO_ROOM = -1;

  /** A robot tells no larger number of tries. */
  static final int MAX_TRIES = 255;

  Report {
    tries = List.copyOf(tries);
    seen = List.copyOf(seen);
  }

  /**
   * A leader's word.
   *
   * @param term in which it leads; a later term's word counts
   * @param tasks who is to go where
   */
  record Duty(long term, SortedMap<RobotId, Task> tasks) {}

  /**
   * One room for one robot.
   *
   * @param number from 1 in each term, never twice: a robot takes a task once
   */
  record Task(int room, int number) {}

  boolean isIdle() {
    return room == NO_ROOM;
  }

  /** Whether this says more than {@code other}, which is of the same robot. */
  boolean isNewerThan(Report other) {
    int byLife = Long.compare(from.inc(), other.from.inc());
    return byLife > 0 || (byLife == 0 && number > other.number);
  }
}
