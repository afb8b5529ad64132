package org.starl.apps.search.logic;

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
 * The bytes of a {@link Report}: who (process), number (i64), whether there is a place (bool; x and y,
 * i32 each), room (u8, 255 for none), what was seen of it (how many lengths u8, each u16), one byte for each room (its lowest bit: swept), one byte for each
 * room with the tries, whether there is a duty (bool; term i64, how many u8, each robot, room u8, number i32),
 * whether there is an answer (bool; the {@link Answer}).
 */
final class ReportCodec implements Codec<Report> {

  static final int MAX_ROOMS = 200;

  private static final int NONE = 255;

  private final int rooms;

  ReportCodec(int rooms) {
    this.rooms = rooms;
    if (rooms > MAX_ROOMS) {
      throw new IllegalArgumentException(rooms + " rooms: expected at most " + MAX_ROOMS);
    }
  }

  @Override
  public void write(Report report, WireWriter out) {
    out.process(report.from());
    out.i64(report.number());
    out.bool(report.at().isPresent());
    if (report.at().isPresent()) {
      out.i32((int) Math.round(report.at().get().xMm()));
      out.i32((int) Math.round(report.at().get().yMm()));
    }
    out.u8(report.isIdle() ? NONE : report.room());
    out.u8(report.seen().size());
    report.seen().forEach(out::u16);
    for (int room = 0; room < rooms; room++) {
      out.bool(report.swept().contains(room));
    }
    for (int room = 0; room < rooms; room++) {
      out.u8(report.tries().get(room));
    }
    out.bool(report.duty().isPresent());
    report.duty().ifPresent(duty -> write(duty, out));
    out.bool(report.answer().isPresent());
    report.answer().ifPresent(answer -> Answer.write(answer, out));
  }

  private static void write(Report.Duty duty, WireWriter out) {
    out.i64(duty.term());
    out.u8(duty.tasks().size());
    duty.tasks()
        .forEach((robot, task) -> {
          out.robot(robot);
          out.u8(task.room());
          out.i32(task.number());
        });
  }

  @Override
  public Report read(WireReader in) {
    ProcessId from = in.process();
    long number = in.i64();
    Optional<Point> at = in.bool() ? Optional.of(point(in)) : Optional.empty();
    int room = in.u8();
    int count = in.u8();
    List<Integer> seen = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      seen.add(in.u16());
    }
    SortedSet<Integer> swept = new TreeSet<>();
    for (int i = 0; i < rooms; i++) {
      if (in.bool()) {
        swept.add(i);
      }
    }
    List<Integer> tries = new ArrayList<>(rooms);
    for (int i = 0; i < rooms; i++) {
      tries.add(in.u8());
    }
    Optional<Report.Duty> duty = in.bool() ? Optional.of(duty(in)) : Optional.empty();
    Optional<Answer> answer = in.bool() ? Optional.of(Answer.read(in)) : Optional.empty();
    int itsRoom = room == NONE ? Report.NO_ROOM : known(room);
    return new Report(from, number, at, itsRoom, seen, swept, tries, duty, answer);
  }

  private static Point point(WireReader in) {
    int xMm = in.i32();
    return new Point(xMm, in.i32());
  }

  private Report.Duty duty(WireReader in) {
    long term = in.i64();
    int count = in.u8();
    SortedMap<RobotId, Report.Task> duties = new TreeMap<>();
    for (int i = 0; i < count; i++) {
      RobotId robot = in.robot();
      int room = known(in.u8());
      duties.put(robot, new Report.Task(room, in.i32()));
    }
    return new Report.Duty(term, duties);
  }

  private int known(int room) {
    if (room >= rooms) {
      throw new WireFormatException("room " + room + " of " + rooms);
    }
    return room;
  }
}
