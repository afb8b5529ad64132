package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.geometry.Point;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.random.Rng;

/** Reports travel unchanged, and grow into one another whatever their order. */
class ReportTest {

  private static final RobotId BOT = new RobotId("bot1");
  private static final int ROOMS = 2;

  private static House house(long seed) {
    return House.of(SweepTest.drawn(new Rng(seed)), 600, 280);
  }

  private static Report report(long number, int room, List<Integer> seen, List<Integer> swept) {
    Report.Duty duty =
        new Report.Duty(7, new TreeMap<>(java.util.Map.of(BOT, new Report.Task(1, 3))));
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
    new ReportCodec(ROOMS).write(report, out);
    return java.util.Arrays.copyOf(buffer, out.length());
  }

  @Test
  void whatIsWrittenIsRead() {
    for (Report report :
        List.of(
            report(1, Report.NO_ROOM, List.of(), List.of()),
            report(2, 1, List.of(0, 65_535), List.of(0, 1)))) {
      assertThat(new ReportCodec(ROOMS).read(new WireReader(bytes(report)))).isEqualTo(report);
    }
    for (Answer answer : List.of(new Answer.Nothing(), new Answer.Found("x", -1, 2, "bot3"))) {
      assertThat(Answer.of(Answer.toBytes(answer))).isEqualTo(answer);
    }
  }

  @Test
  void aRoomThatIsNotThereIsNotRead() {
    byte[] bytes = bytes(report(1, 1, List.of(), List.of()));
    assertThatThrownBy(() -> new ReportCodec(1).read(new WireReader(bytes)))
        .isInstanceOf(WireFormatException.class);
    assertThatThrownBy(() -> Answer.of(new byte[] {9})).isInstanceOf(WireFormatException.class);
  }

  @Property(tries = 50)
  void lengthsStandForTheCells(@ForAll long seed) {
    House house = house(seed);
    Room room = house.room(0);
    Rng rng = new Rng(seed);
    BitSet part = new BitSet();
    boolean[] isIn = {false};
    room.forEachCell(cell -> {
      isIn[0] ^= rng.nextBoolean(0.02);
      part.set(cell, isIn[0]);
    });
    List<Integer> runs = Runs.of(part, room);
    BitSet back = Runs.cells(runs, room);
    if (runs.size() < Runs.MAX) {
      assertThat(back).isEqualTo(part);
    } else {
      back.andNot(part);
      assertThat(back.isEmpty()).as("never more than there was").isTrue();
    }
  }

  @Property(tries = 50)
  void whateverLengthsSayIsInTheRoom(@ForAll List<Integer> lengths) {
    Room room = house(1).room(0);
    List<Integer> runs = lengths.stream().map(length -> length & 0xFFFF).toList();
    BitSet cells = Runs.cells(runs, room);
    cells.andNot(room.cells());
    assertThat(cells.isEmpty()).isTrue();
  }

  @Test
  void whatWasSeenStaysSeenAndTheLaterTermLeads() {
    House house = house(1);
    Board board = new Board(house);
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
    assertThat(board.hear(first)).isTrue();
    assertThat(board.hear(first)).as("again").isFalse();
    Report reborn =
        new Report(
            new ProcessId(BOT, 6),
            1,
            Optional.empty(),
            Report.NO_ROOM,
            List.of(),
            new TreeSet<>(List.of(0)),
            List.of(0),
            Optional.of(new Report.Duty(1, new TreeMap<>())),
            Optional.of(new Answer.Nothing()));
    assertThat(board.hear(reborn)).as("of a later life").isTrue();
    assertThat(board.hear(first)).as("late").isFalse();
    assertThat(board.seen(0).cardinality()).isEqualTo(10);
    assertThat(board.isSwept(0)).isTrue();
    assertThat(board.duty().orElseThrow().term()).isEqualTo(2);
    assertThat(board.answer()).contains(new Answer.Nothing());
  }
}
