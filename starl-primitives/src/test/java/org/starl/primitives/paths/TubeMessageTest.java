package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.random.Rng;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class TubeMessageTest {

  private final Shape<TubeMessage> shape = TubeMessage.SHAPE;

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void everyMessageIsReadAsItWasWritten(@ForAll long seed) {
    TubeMessage message = message(new Rng(seed));
    WireReader in = new WireReader(bytes(message));
    assertThat(shape.read(in)).isEqualTo(message);
    assertThat(in.remaining()).isZero();
  }

  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void damagedBytesAreReadOrRefused(@ForAll long seed) {
    Rng rng = new Rng(seed);
    byte[] damaged = bytes(message(rng));
    int at = rng.nextInt(damaged.length);
    damaged[at] ^= (byte) (1 + rng.nextInt(255));
    readsOrRefuses(damaged);
    readsOrRefuses(Arrays.copyOf(damaged, at));
  }

  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void messagesAndTubesAreReadFromTheirJson(@ForAll long seed) throws JsonFormatException {
    Rng rng = new Rng(seed);
    TubeMessage message = message(rng);
    assertThat(reread(shape, message)).isEqualTo(message);
    TubeList held = new TubeList(holding(rng, Tube.MAX_POINTS).held());
    assertThat(reread(TubeList.SHAPE, held)).isEqualTo(held);
  }

  private static <T> T reread(Shape<T> shape, T value) throws JsonFormatException {
    return shape.readJson(new JsonReader("", 1, shape.json(value)));
  }

  @Test
  void theLongestMessageFitsADatagramAndStoredBytesAreReadBack() {
    List<Point> line = new ArrayList<>();
    for (int i = 0; i < Tube.MAX_POINTS; i++) {
      line.add(new Point(-PlanTask.MAX_MM + i, PlanTask.MAX_MM - i));
    }
    Tube tube = new Tube(line, PlanTask.MAX_MM);
    Holding full = new Holding(Long.MAX_VALUE, List.of(tube, tube), List.of(tube));
    RobotId longest = new RobotId("a".repeat(RobotId.MAX_LENGTH));
    TubeMessage message = new TubeMessage.Refuse(Long.MAX_VALUE, longest, full);
    assertThat(bytes(message).length).isLessThan(Radio.MAX_BYTES - 150);
    TubeVoter.Note note = new TubeVoter.Note(full, true);
    byte[] stored = WireWriter.toBytes(out -> TubeVoter.Note.SHAPE.write(note, out));
    assertThat(TubeVoter.Note.SHAPE.read(new WireReader(stored))).isEqualTo(note);
  }

  @Test
  void theBytesAreThoseOfTheWireFormat() {
    Tube tube = new Tube(List.of(new Point(1, 2), new Point(-1, 258)), 300);
    byte[] refusal = {
      3, 0, 0, 0, 0, 0, 0, 0, 9, 1, 'a', 0, 0, 0, 0, 0, 0, 0, 5, 1, 0, 0, 1, 44, 2, 0, 0, 0, 1, 0,
      0, 0, 2, -1, -1, -1, -1, 0, 0, 1, 2, 0
    };
    Holding theirs = new Holding(5, List.of(tube), List.of());
    assertThat(bytes(new TubeMessage.Refuse(9, new RobotId("a"), theirs))).isEqualTo(refusal);
    assertThat(bytes(new TubeMessage.Vote(9))).isEqualTo(new byte[] {2, 0, 0, 0, 0, 0, 0, 0, 9});
  }

  @Test
  void invalidTubesAreRefused() {
    byte[] noPoints = {1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0};
    assertThatThrownBy(() -> shape.read(new WireReader(noPoints)))
        .isInstanceOf(WireFormatException.class);
  }

  private static TubeMessage message(Rng rng) {
    return switch (rng.nextInt(3)) {
      case 0 -> new TubeMessage.Ask(holding(rng, Tube.MAX_POINTS));
      case 1 -> new TubeMessage.Vote(rng.nextLong(0, Long.MAX_VALUE));
      default ->
          new TubeMessage.Refuse(
              rng.nextLong(0, Long.MAX_VALUE), new RobotId("bot7"), holding(rng, 10));
    };
  }

  private static Holding holding(Rng rng, int maxPoints) {
    List<Tube> held = new ArrayList<>();
    for (int i = rng.nextInt(3); i > 0; i--) {
      held.add(tube(rng, maxPoints));
    }
    List<Tube> wanted = rng.nextBoolean(0.5) ? List.of(tube(rng, maxPoints)) : List.of();
    return new Holding(rng.nextLong(0, Long.MAX_VALUE), held, wanted);
  }

  private static Tube tube(Rng rng, int maxPoints) {
    List<Point> points = new ArrayList<>();
    for (int i = rng.nextInt(maxPoints); i >= 0; i--) {
      points.add(new Point(rng.nextLong(-10_000, 10_000), rng.nextLong(-10_000, 10_000)));
    }
    return new Tube(points, 1 + rng.nextInt(1_000));
  }

  private byte[] bytes(TubeMessage message) {
    byte[] buffer = new byte[Radio.MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    shape.write(message, out);
    return Arrays.copyOf(buffer, out.length());
  }

  private void readsOrRefuses(byte[] bytes) {
    try {
      assertThat(shape.read(new WireReader(bytes))).isNotNull();
    } catch (WireFormatException refused) {
      assertThat(refused.getMessage()).isNotBlank();
    }
  }
}
