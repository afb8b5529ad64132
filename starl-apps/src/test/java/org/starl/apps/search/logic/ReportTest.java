package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** Reports are read as they were written, and may be heard in any order. */
class ReportTest {

  private static final RobotId BOT = new RobotId("bot1");
  private static final int ROOMS = 2;

  private static House house(long seed) {
    return House.of(SweepTest.drawn(new Rng(seed)), 600, 280);
  }

  private static Report report(long number, int room, List<Integer> seen, List<Integer> swept) {
    Report.Duty duty = new Report.Duty(7, new TreeMap<>(Map.of(BOT, new Report.Task(1, 3))));
    return new Report(
        new ProcessId(BOT, 5),
        number,
        Optional.of(new Point(12, -7)),
        room,
        seen,
        new TreeSet<>(swept),
        List.of(0, 255),
        Optional.of(duty),
        Optional.of(new Answer.GaveUp(List.of("A", "B"))));
  }

  private static byte[] bytes(Report report) {
    byte[] buffer = new byte[1_000];
    WireWriter out = new WireWriter(buffer);
    Report.shape(ROOMS).write(report, out);
    return Arrays.copyOf(buffer, out.length());
  }

  @Test
  void aReportIsReadAsItWasWritten() {
    for (Report report :
        List.of(
            report(1, Report.NO_ROOM, List.of(), List.of()),
            report(2, 1, List.of(0, 65_535), List.of(0, 1)))) {
      assertThat(Report.shape(ROOMS).read(new WireReader(bytes(report)))).isEqualTo(report);
    }
  }

  @Test
  void aPlaceBetweenMillimetresIsTheSameHereAndWhereItArrives() {
    Report report =
        new Report(
            new ProcessId(BOT, 5),
            1,
            Optional.of(new Point(11.6, -7.4)),
            Report.NO_ROOM,
            List.of(),
            new TreeSet<>(),
            List.of(0, 0),
            Optional.empty(),
            Optional.empty());
    assertThat(report.at()).hasValue(new Point(12, -7));
    assertThat(Report.shape(ROOMS).read(new WireReader(bytes(report)))).isEqualTo(report);
  }

  /** Robots of several versions must understand each other. */
  @Test
  void theBytesOfAReportStayTheSame() {
    Report report = report(2, 1, List.of(0, 65_535), List.of(0));
    String from = "04626f7431" + "0000000000000005";
    String number = "0000000000000002";
    String at = "01" + "0000000c" + "fffffff9";
    String rooms = "01" + "02" + "0000" + "ffff" + "0100" + "00ff";
    String duty = "01" + "0000000000000007" + "01" + "04626f7431" + "01" + "00000003";
    String answer = "01" + "03" + "02" + "0141" + "0142"; // gave up, could not search A, B
    assertThat(HexFormat.of().formatHex(bytes(report)))
        .isEqualTo(from + number + at + rooms + duty + answer);
  }

  /** A reader of traces does not know how many rooms the house has. */
  @Test
  void aReportIsReadFromJson() throws JsonFormatException {
    for (Report report :
        List.of(
            report(1, Report.NO_ROOM, List.of(), List.of()),
            report(2, 1, List.of(3), List.of(0)))) {
      String json = Report.shape(ROOMS).json(report);
      assertThat(Report.shape(Report.MAX_ROOMS).readJson(new JsonReader("trace", 1, json)))
          .isEqualTo(report);
    }
  }

  @Test
  void aReportOfAnUnknownRoomIsRefused() {
    byte[] bytes = bytes(report(1, 1, List.of(), List.of()));
    assertThatThrownBy(() -> Report.shape(1).read(new WireReader(bytes)))
        .isInstanceOf(WireFormatException.class);
  }

  @Property(tries = 50)
  void runLengthsNameTheCells(@ForAll long seed) {
    House house = house(seed);
    Room room = house.room(0);
    Rng rng = new Rng(seed);
    BitSet part = new BitSet();
    boolean[] isIn = {false};
    room.cells().stream()
        .forEach(cell -> {
          isIn[0] ^= rng.nextBoolean(0.02);
          part.set(cell, isIn[0]);
        });
    List<Integer> runs = RunLengths.of(part, room);
    BitSet back = RunLengths.cells(runs, room);
    if (runs.size() < RunLengths.MAX) {
      assertThat(back).isEqualTo(part);
    } else {
      back.andNot(part);
      assertThat(back.isEmpty()).as("no other cells").isTrue();
    }
  }

  @Property(tries = 50)
  void anyRunLengthsNameCellsOfTheRoom(@ForAll List<Integer> lengths) {
    Room room = house(1).room(0);
    List<Integer> runs = lengths.stream().map(length -> length & 0xFFFF).toList();
    BitSet cells = RunLengths.cells(runs, room);
    cells.andNot(room.cells());
    assertThat(cells.isEmpty()).isTrue();
  }

  @Test
  void cellsStaySeenAndTheLaterTermLeads() {
    House house = house(1);
    Knowledge known = new Knowledge(house);
    Report first =
        new Report(
            new ProcessId(BOT, 5),
            4,
            Optional.empty(),
            0,
            List.of(0, 10),
            new TreeSet<>(),
            List.of(0),
            Optional.of(new Report.Duty(2, new TreeMap<>())),
            Optional.empty());
    known.hear(first);
    Report reborn =
        new Report(
            ProcessId.first(BOT, 6),
            1,
            Optional.empty(),
            Report.NO_ROOM,
            List.of(),
            new TreeSet<>(List.of(0)),
            List.of(0),
            Optional.of(new Report.Duty(1, new TreeMap<>())),
            Optional.of(Answer.NOTHING));
    known.hear(reborn);
    known.hear(first); // late: it must not replace the report of the later incarnation
    assertThat(known.latest()).containsEntry(BOT, reborn);
    assertThat(known.seen(0).cardinality()).isEqualTo(10);
    assertThat(known.swept()).containsExactly(0);
    assertThat(known.duty().orElseThrow().term()).isEqualTo(2);
    assertThat(known.answer()).contains(Answer.NOTHING);
  }
}
