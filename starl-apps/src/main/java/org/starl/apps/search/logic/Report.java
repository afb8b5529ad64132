package org.starl.apps.search.logic;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.PROCESS;
import static org.starl.shape.Shapes.ROBOT;
import static org.starl.shape.Shapes.U16;
import static org.starl.shape.Shapes.U8;
import static org.starl.shape.Shapes.part;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.geometry.Point;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * All that a robot tells the others. Each report is complete and replaces the one before, so loss,
 * duplication and reordering do no harm. Rooms are given by their numbers.
 *
 * @param from this incarnation of the robot
 * @param number grows with each report of an incarnation
 * @param at where the robot is, in whole mm, if it knows
 * @param room the room that it searches or drives to, or {@link #NO_ROOM}
 * @param seen which cells of that room it knows to have been seen, as {@link RunLengths}
 * @param swept rooms that were searched in full, by any robot
 * @param tries how often this incarnation has failed to search each room
 * @param duty what the others have to do, if this robot leads
 * @param answer the answer, if the robot has one
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

  /** No house has more rooms. */
  static final int MAX_ROOMS = 200;

  /** More tries than this are reported as this. */
  static final int MAX_TRIES = 255;

  private static final int NO_ROOM_BYTE = 255;
  private static final int MAX_LIST = 255;

  Report {
    // As its bytes have it: a report is the same here and where it arrives.
    at = at.map(place -> new Point(Math.round(place.xMm()), Math.round(place.yMm())));
    tries = List.copyOf(tries);
    seen = List.copyOf(seen);
    swept = Collections.unmodifiableSortedSet(new TreeSet<>(swept));
  }

  /**
   * A leader's assignments.
   *
   * @param term in which it leads; those of a later term count
   * @param tasks the task of each robot
   */
  record Duty(long term, SortedMap<RobotId, Task> tasks) {
    Duty {
      tasks = Collections.unmodifiableSortedMap(new TreeMap<>(tasks));
    }
  }

  /**
   * One room for one robot.
   *
   * @param number from 1 in each term, never twice: a robot takes a task once
   */
  record Task(int room, int number) {}

  boolean isIdle() {
    return room == NO_ROOM;
  }

  /** Whether it is later than {@code other}, which is of the same robot. */
  boolean isNewerThan(Report other) {
    return from.inc() == other.from.inc() ? number > other.number : from.inc() > other.from.inc();
  }

  /** The parts of a report that are about rooms. */
  private record Rooms(
      int room, List<Integer> seen, SortedSet<Integer> swept, List<Integer> tries) {}

  /**
   * The shape of reports. Bytes, in the order of the components: an optional one begins with a
   * bool; a list with its length (u8). Numbers: number and term i64; x, y (in whole mm) and a
   * task's number i32; run lengths u16; a room u8, 255 for none; for each room of the house {@code
   * swept} has a bool and {@code tries} a u8.
   *
   * @param rooms how many the house has
   */
  static Shape<Report> shape(int rooms) {
    if (rooms > MAX_ROOMS) {
      throw new IllegalArgumentException(rooms + " rooms: expected at most " + MAX_ROOMS);
    }
    Shape<Integer> room = U8.where(number -> checkRoom(number, rooms));
    return Shapes.of(
        Report.class,
        part("from", PROCESS, Report::from),
        part("number", LONG, Report::number),
        part("at", Shapes.optional(place()), Report::at),
        part("rooms", rooms(room, rooms), r -> new Rooms(r.room, r.seen, r.swept, r.tries)),
        part("duty", Shapes.optional(duties(room)), Report::duty),
        part("answer", Shapes.optional(Answer.SHAPE), Report::answer),
        (from, number, at, of, duty, answer) ->
            new Report(from, number, at, of.room, of.seen, of.swept, of.tries, duty, answer));
  }

  private static void checkRoom(int room, int rooms) {
    if (room >= rooms) {
      throw new IllegalArgumentException("room " + room + " of " + rooms);
    }
  }

  private static Shape<Point> place() {
    return Geometry.POINT.bytes(
        (at, out) -> {
          out.i32((int) at.xMm());
          out.i32((int) at.yMm());
        },
        in -> new Point(in.i32(), in.i32()));
  }

  private static Shape<Rooms> rooms(Shape<Integer> room, int rooms) {
    return Shapes.of(
        Rooms.class,
        part("room", roomOrNone(room, rooms), Rooms::room),
        part("seen", Shapes.list(U16, MAX_LIST), Rooms::seen),
        part("swept", swept(room, rooms), Rooms::swept),
        part("tries", tries(rooms), Rooms::tries),
        Rooms::new);
  }

  private static Shape<Integer> roomOrNone(Shape<Integer> room, int rooms) {
    return Shapes.optional(room)
        .<Integer>as(
            "room or null",
            number -> number == NO_ROOM ? Optional.empty() : Optional.of(number),
            number -> number.orElse(NO_ROOM))
        .bytes(
            (number, out) -> out.u8(number == NO_ROOM ? NO_ROOM_BYTE : number),
            in -> {
              int number = in.u8();
              if (number == NO_ROOM_BYTE) {
                return NO_ROOM;
              }
              checkRoom(number, rooms);
              return number;
            });
  }

  private static Shape<SortedSet<Integer>> swept(Shape<Integer> room, int rooms) {
    return Shapes.set(room, MAX_ROOMS)
        .bytes(
            (swept, out) -> {
              for (int i = 0; i < rooms; i++) {
                out.bool(swept.contains(i));
              }
            },
            in -> {
              SortedSet<Integer> swept = new TreeSet<>();
              for (int i = 0; i < rooms; i++) {
                if (in.bool()) {
                  swept.add(i);
                }
              }
              return swept;
            });
  }

  private static Shape<List<Integer>> tries(int rooms) {
    return Shapes.list(U8, MAX_ROOMS)
        .bytes((tries, out) -> tries.forEach(out::u8), in -> in.list(rooms, U8::read));
  }

  private static Shape<Duty> duties(Shape<Integer> room) {
    Shape<Task> task =
        Shapes.of(
            Task.class,
            part("room", room, Task::room),
            part("number", INT, Task::number),
            Task::new);
    return Shapes.of(
        Duty.class,
        part("term", LONG, Duty::term),
        part("tasks", Shapes.map(ROBOT, task, MAX_LIST), Duty::tasks),
        Duty::new);
  }
}
