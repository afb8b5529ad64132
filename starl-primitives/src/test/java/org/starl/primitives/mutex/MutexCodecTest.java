package org.starl.primitives.mutex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.MutexMessage.Fence;
import org.starl.primitives.mutex.MutexMessage.FenceQ;
import org.starl.primitives.mutex.MutexMessage.Fenced;
import org.starl.primitives.mutex.MutexMessage.Noted;
import org.starl.primitives.mutex.MutexMessage.Ok;
import org.starl.primitives.mutex.MutexMessage.Rem;
import org.starl.primitives.mutex.MutexMessage.Req;
import org.starl.primitives.mutex.MutexMessage.Wish;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class MutexCodecTest {

  private static final ProcessId ONE = new ProcessId(new RobotId("one"), 1);
  private static final ProcessId TWO = new ProcessId(new RobotId("two"), (7L << 32) + 3);

  private final Shape<MutexMessage> codec = MutexMessage.SHAPE;

  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void everyMessageIsReadAsItWasWritten(@ForAll("messages") MutexMessage message) {
    WireReader in = new WireReader(bytes(message));
    assertThat(codec.read(in)).isEqualTo(message);
    assertThat(in.remaining()).isZero();
  }

  @Property(tries = 2_000, edgeCases = EdgeCasesMode.NONE)
  void damagedBytesAreRefusedOrEncodeAnotherMessage(
      @ForAll("messages") MutexMessage message, @ForAll long seed) {
    byte[] damaged = bytes(message);
    int at = (int) Math.floorMod(seed, (long) damaged.length);
    damaged[at] ^= (byte) (1 + Math.floorMod(seed >> 8, 255L));
    readsOrRefuses(damaged);
    readsOrRefuses(Arrays.copyOf(damaged, at));
  }

  @Test
  void theLongestRequestLeavesRoomForItsDatagramsHeader() {
    TreeSet<String> sections = new TreeSet<>();
    for (int i = 0; i < Sections.MAX_COUNT; i++) {
      sections.add("s".repeat(Sections.MAX_LENGTH - 2) + (10 + i));
    }
    ProcessId from = new ProcessId(new RobotId("a".repeat(RobotId.MAX_LENGTH)), 1);
    ProcessId to = new ProcessId(new RobotId("b".repeat(RobotId.MAX_LENGTH)), 1);
    byte[] bytes = bytes(new Req(from, to, 1, 1, 1, Sections.copyOf(sections)));
    // Two robot names, a channel name, 26 bytes before them, 40 bytes for authentication.
    assertThat(bytes.length + 33 + 33 + 64 + 26 + 40).isLessThanOrEqualTo(Radio.MAX_BYTES);
    String half = sections.last();
    Ok parts = new Ok(from, to, 1, sections.headSet(half), sections.tailSet(half));
    assertThat(bytes(parts).length).isLessThanOrEqualTo(bytes.length);
  }

  @Test
  void invalidMessagesAreRefused() {
    Req req = new Req(ONE, TWO, 1, 1, 1, Sections.copyOf(List.of("A", "B")));
    assertThatThrownBy(() -> codec.read(new WireReader(with(req, 0, 9))))
        .hasMessage("MutexMessage kind 9");
    int last = bytes(req).length - 1;
    assertThatThrownBy(() -> codec.read(new WireReader(with(req, last, 'A'))))
        .as("a name twice")
        .isInstanceOf(WireFormatException.class);
    assertThatThrownBy(() -> codec.read(new WireReader(with(req, last, '!'))))
        .as("a bad letter")
        .isInstanceOf(WireFormatException.class);
    byte[] forNothing = Arrays.copyOf(bytes(req), bytes(req).length - 4);
    forNothing[forNothing.length - 1] = 0;
    assertThatThrownBy(() -> codec.read(new WireReader(forNothing)))
        .isInstanceOf(WireFormatException.class)
        .hasMessage("request without sections");
    byte[] toItself =
        WireWriter.toBytes(out -> {
          out.u8(2);
          out.process(ONE);
          out.process(ONE);
          out.i64(1);
          out.u8(0);
          out.u8(0);
        });
    assertThatThrownBy(() -> codec.read(new WireReader(toItself)))
        .isInstanceOf(WireFormatException.class)
        .hasMessage("a message of one.0 to or about itself");
    assertThatThrownBy(() -> new FenceQ(ONE, TWO, ONE, 1))
        .hasMessage("a message of one.0 to or about itself");
    assertThatThrownBy(() -> read(new Ok(ONE, TWO, 0))).hasMessage("request number 0");
    assertThatThrownBy(() -> read(new Req(ONE, TWO, 1, 1, 1L << 62, req.want())))
        .hasMessageStartingWith("logical time");
  }

  @Test
  void sectionNamesAreChecked() {
    for (String bad : List.of("", "a b", "é", "x".repeat(33), "a*2", "a\n")) {
      assertThatThrownBy(() -> Sections.copyOf(List.of(bad)))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("expected 1 to 32 of");
    }
    List<String> many = new ArrayList<>();
    for (int i = 0; i < 33; i++) {
      many.add("s" + i);
    }
    assertThatThrownBy(() -> Sections.copyOf(many)).hasMessageStartingWith("33 sections");
  }

  @Provide
  Arbitrary<MutexMessage> messages() {
    Arbitrary<ProcessId> from = Arbitraries.longs().greaterOrEqual(1).map(inc -> id("one", inc));
    Arbitrary<ProcessId> to = Arbitraries.longs().greaterOrEqual(1).map(inc -> id("two", inc));
    Arbitrary<Long> positive = Arbitraries.longs().between(1, (1L << 62) - 1);
    Arbitrary<TreeSet<String>> names =
        Arbitraries.strings()
            .withChars("ABab01_-.:")
            .ofMinLength(1)
            .ofMaxLength(32)
            .set()
            .ofMaxSize(8)
            .map(TreeSet::new);
    return Combinators.combine(from, to, positive, positive, positive, names)
        .flatAs((f, t, num, by, ts, left) -> {
          TreeSet<String> want = new TreeSet<>(left);
          want.add("Z");
          return Arbitraries.of(
              new Req(f, t, num, by, ts, want),
              new Req(f, t, num, by, ts, new Wish(MutexMessage.Kind.SEQUENCE, want, left)),
              new Req(f, t, num, by, ts, new Wish(MutexMessage.Kind.RESUMED, want, left)),
              new Ok(f, t, num),
              new Ok(f, t, num, left),
              new Ok(f, t, num, left, Sections.copyOf(List.of("A/e*2"))),
              new Noted(f, t, num, num),
              new Rem(f, t, num, left),
              new Noted(f, t, num),
              new FenceQ(f, t, id("three", num), by),
              new Fence(f, t, id("three", num), left),
              new Fenced(f, t));
        });
  }

  private static ProcessId id(String robot, long inc) {
    return new ProcessId(new RobotId(robot), inc);
  }

  private void readsOrRefuses(byte[] bytes) {
    WireReader in = new WireReader(bytes);
    try {
      MutexMessage read = codec.read(in);
      if (in.remaining() == 0) {
        assertThat(bytes(read)).isEqualTo(bytes);
      }
    } catch (WireFormatException refused) {
      assertThat(refused).hasMessageNotContaining("null");
    }
  }

  private void read(MutexMessage message) {
    codec.read(new WireReader(bytes(message)));
  }

  private byte[] with(MutexMessage message, int at, int value) {
    byte[] bytes = bytes(message);
    bytes[at] = (byte) value;
    return bytes;
  }

  private byte[] bytes(MutexMessage message) {
    byte[] buffer = new byte[Radio.MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    codec.write(message, out);
    return Arrays.copyOf(buffer, out.length());
  }
}
