package org.starl.primitives.barrier;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.barrier.BarrierMessage.Arrival;
import org.starl.primitives.barrier.BarrierMessage.Here;
import org.starl.shape.JsonFormatException;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class BarrierCodecTest {

  private static final ProcessId B1 = new ProcessId(new RobotId("b1"), 5);
  private static final ProcessId B2 = new ProcessId(new RobotId("b2"), 6);
  private static final ProcessId B3 = new ProcessId(new RobotId("b3"), 7);

  private static final Shape<BarrierMessage> CODEC = BarrierMessage.SHAPE;

  private final OutcomesFormat format = new OutcomesFormat(new TreeSet<>(List.of(B1, B2, B3)));

  /** The bytes of {@code docs/wire-format.md}, Barrier messages. */
  @Test
  void theBytesAreAsDocumented() {
    assertThat(hex(new Arrival(B1, 7)))
        .isEqualTo("01" + "026231" + "0000000000000005" + "0000000000000007");
    assertThat(hex(new Here(B1, 7, true, 8)))
        .isEqualTo(
            "02" + "026231" + "0000000000000005" + "0000000000000007" + "01" + "0000000000000008");
    Outcomes outcomes = Outcomes.ALL_PASSED.withBroken(4, List.of(B3, B1));
    assertThat(HexFormat.of().formatHex(format.toValue(outcomes).bytes()))
        .isEqualTo("0001" + "0000000000000004" + "0002" + "0000" + "0002");
  }

  @Property(tries = 100)
  void writtenMessagesAreReadBack(
      @ForAll @LongRange(min = 1) long generation,
      @ForAll @LongRange(min = 1) long noted,
      @ForAll boolean hasArrived)
      throws JsonFormatException {
    for (BarrierMessage message :
        List.of(new Arrival(B1, generation), new Here(B1, generation, hasArrived, noted))) {
      assertThat(CODEC.read(new WireReader(bytes(message)))).isEqualTo(message);
      assertThat(OneSpelling.fromJson(CODEC, CODEC.json(message))).isEqualTo(message);
    }
  }

  @Property(tries = 100)
  void outcomesAreReadBack(@ForAll @Size(3) List<@LongRange(min = 1, max = 5) Long> leftOutBy) {
    Outcomes outcomes = Outcomes.ALL_PASSED;
    List<ProcessId> ids = List.of(B1, B2, B3);
    for (long generation = 1; generation <= 4; generation++) {
      SortedSet<ProcessId> missing = new TreeSet<>();
      for (int i = 0; i < 3; i++) {
        if (leftOutBy.get(i) == generation) {
          missing.add(ids.get(i));
        }
      }
      outcomes = missing.isEmpty() ? outcomes : outcomes.withBroken(generation, missing);
    }
    assertThat(format.read(format.toValue(outcomes))).isEqualTo(outcomes);
    for (int i = 0; i < 3; i++) {
      long expected = leftOutBy.get(i) == 5 ? 0 : leftOutBy.get(i);
      assertThat(outcomes.leftOutBy(ids.get(i))).isEqualTo(expected);
      assertThat(outcomes.members(new TreeSet<>(ids), 5).contains(ids.get(i)))
          .isEqualTo(expected == 0);
    }
  }

  @Test
  void theLargestGroupFitsOneMessage() {
    OutcomesFormat big = new OutcomesFormat(members(83));
    Outcomes outcomes = Outcomes.ALL_PASSED;
    long generation = 1;
    for (ProcessId id : members(83)) {
      outcomes = outcomes.withBroken(generation++, List.of(id));
    }
    assertThat(big.toValue(outcomes).length()).isLessThanOrEqualTo(Value.MAX_BYTES);
    assertThatThrownBy(() -> new OutcomesFormat(members(84)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("84 members");
  }

  @Test
  void malformedMessagesAndOutcomesAreRefused() {
    byte[] generationZero = bytes(new Arrival(B1, 1));
    generationZero[19] = 0;
    byte[] otherKind = bytes(new Arrival(B1, 1));
    otherKind[0] = 3;
    for (byte[] bad : new byte[][] {generationZero, otherKind, {1}, {}}) {
      assertThatThrownBy(() -> CODEC.read(new WireReader(bad)))
          .isInstanceOf(WireFormatException.class);
    }
    for (String bad :
        List.of(
            "",
            "00000000",
            "0001" + "0000000000000004" + "0000",
            "0001" + "0000000000000004" + "0001" + "0003",
            "0001" + "0000000000000000" + "0001" + "0000",
            "0002" + "0000000000000004" + "00010000" + "0000000000000004" + "00010001")) {
      Value value = Value.of(HexFormat.of().parseHex(bad));
      assertThatThrownBy(() -> format.checkValue(1, value)).isInstanceOf(WireFormatException.class);
    }
    assertThatThrownBy(() -> format.checkWish(format.toValue(Outcomes.ALL_PASSED)))
        .isInstanceOf(WireFormatException.class);
  }

  private static SortedSet<ProcessId> members(int count) {
    SortedSet<ProcessId> ids = new TreeSet<>();
    for (int i = 0; i < count; i++) {
      ids.add(new ProcessId(new RobotId("a-rather-long-name-for-robot-" + i), 1));
    }
    return ids;
  }

  private static String hex(BarrierMessage message) {
    return HexFormat.of().formatHex(bytes(message));
  }

  private static byte[] bytes(BarrierMessage message) {
    byte[] buffer = new byte[100];
    WireWriter out = new WireWriter(buffer);
    CODEC.write(message, out);
    return Arrays.copyOf(buffer, out.length());
  }
}
