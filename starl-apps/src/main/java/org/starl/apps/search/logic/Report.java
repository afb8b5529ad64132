package org.starl.apps.search.logic;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.comms.Codec;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.geometry.Point;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/**
 * All that a robot tells the others. Each report is complete and replaces the one before, so loss,
 * duplication and reordering do no harm. Rooms are given by their numbers.
 *
 * @param from this incarnation of the robot
 * @param number grows with each report of an incarnation
 * @param at where the robot is, if it knows
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
    Optional<String> answer) {

  static final int NO_ROOM = -1;

  /** More tries than this are reported as this. */
  static final int MAX_TRIES = 255;

  private static final int NO_ROOM_BYTE = 255;

  Report {
    tries = List.copyOf(tries);
    seen = List.copyOf(seen);
  }

  /**
   * A leader's assignments.
   *
   * @param term in which it leads; those of a later term count
   * @param tasks the task of each robot
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

  /** Whether it is later than {@code other}, which is of the same robot. */
  boolean isNewerThan(Report other) {
    return from.inc() == other.from.inc() ? number > other.number : from.inc() > other.from.inc();
  }

  /**
   * The bytes of a report, in the order of its components. An optional one begins with a bool; a
   * list with its length (u8). Numbers: number and term i64; x, y and a task's number i32; run
   * lengths u16; a room u8, 255 for none; for each room of the house {@code swept} has a bool and
   * {@code tries} a u8; the answer is bytes in UTF-8.
   *
   * @param rooms how many the house has
   */
  record Wire(int rooms) implements Codec<Report> {

    private static final int MAX_ROOMS = 200;

    Wire {
      if (rooms > MAX_ROOMS) {
        throw new IllegalArgumentException(rooms + " rooms: expected at most " + MAX_ROOMS);
      }
    }

    @Override
    public void write(Report report, WireWriter out) {
      out.process(report.from);
      out.i64(report.number);
      out.bool(report.at.isPresent());
      report.at.ifPresent(at -> {
        out.i32((int) Math.round(at.xMm()));
        out.i32((int) Math.round(at.yMm()));
      });
      out.u8(report.isIdle() ? NO_ROOM_BYTE : report.room);
      out.u8(report.seen.size());
      report.seen.forEach(out::u16);
      for (int room = 0; room < rooms; room++) {
        out.bool(report.swept.contains(room));
      }
      report.tries.forEach(out::u8);
      out.bool(report.duty.isPresent());
      report.duty.ifPresent(duty -> {
        out.i64(duty.term);
        out.u8(duty.tasks.size());
        duty.tasks.forEach((robot, task) -> {
          out.robot(robot);
          out.u8(task.room);
          out.i32(task.number);
        });
      });
      out.bool(report.answer.isPresent());
      report.answer.ifPresent(answer -> out.bytes(answer.getBytes(StandardCharsets.UTF_8)));
    }

    @Override
    public Report read(WireReader in) {
      ProcessId from = in.process();
      long number = in.i64();
      Optional<Point> at =
          in.bool() ? Optional.of(new Point(in.i32(), in.i32())) : Optional.empty();
      int roomByte = in.u8();
      int room = roomByte == NO_ROOM_BYTE ? NO_ROOM : known(roomByte);
      List<Integer> seen = new ArrayList<>();
      for (int left = in.u8(); left > 0; left--) {
        seen.add(in.u16());
      }
      SortedSet<Integer> swept = new TreeSet<>();
      for (int i = 0; i < rooms; i++) {
        if (in.bool()) {
          swept.add(i);
        }
      }
      List<Integer> tries = new ArrayList<>();
      for (int i = 0; i < rooms; i++) {
        tries.add(in.u8());
      }
      Optional<Duty> duty = in.bool() ? Optional.of(duty(in)) : Optional.empty();
      Optional<String> answer =
          in.bool()
              ? Optional.of(new String(in.bytes(), StandardCharsets.UTF_8))
              : Optional.empty();
      return new Report(from, number, at, room, seen, swept, tries, duty, answer);
    }

    private Duty duty(WireReader in) {
      long term = in.i64();
      SortedMap<RobotId, Task> tasks = new TreeMap<>();
      for (int left = in.u8(); left > 0; left--) {
        tasks.put(in.robot(), new Task(known(in.u8()), in.i32()));
      }
      return new Duty(term, tasks);
    }

    private int known(int room) {
      if (room >= rooms) {
        throw new WireFormatException("room " + room + " of " + rooms);
      }
      return room;
    }
  }
}
