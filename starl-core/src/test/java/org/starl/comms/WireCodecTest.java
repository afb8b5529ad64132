package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.charset.StandardCharsets;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class WireCodecTest {

  @Provide
  Arbitrary<String> names() {
    Arbitrary<Character> first = Arbitraries.chars().range('a', 'z').range('A', 'Z');
    Arbitrary<String> rest =
        Arbitraries.strings()
            .withCharRange('a', 'z')
            .withCharRange('0', '9')
            .withChars("._-")
            .ofMaxLength(31);
    return first.flatMap(c -> rest.map(tail -> c + tail)).filter(RobotId::isValid);
  }

  @Property
  void aTextIsReadBackToTheEnd(@ForAll String text) {
    Assume.that(text.codePoints().noneMatch(c -> c >= 0xD800 && c <= 0xDFFF));
    byte[] bytes = WireWriter.toBytes(out -> Codec.text().write(text, out));
    assertThat(bytes).isEqualTo(text.getBytes(StandardCharsets.UTF_8));
    assertThat(Codec.text().read(new WireReader(bytes))).isEqualTo(text);
  }

  @Test
  void bytesThatAreNotUtf8AreNoText() {
    assertThatExceptionOfType(WireFormatException.class)
        .isThrownBy(() -> Codec.text().read(new WireReader(new byte[] {(byte) 0xC3})));
  }

  @Property
  void everyFieldIsReadBack(
      @ForAll @IntRange(max = 0xFF) int u8,
      @ForAll boolean bool,
      @ForAll @IntRange(max = 0xFFFF) int u16,
      @ForAll int i32,
      @ForAll long i64,
      @ForAll double f64,
      @ForAll @Size(max = 50) byte[] bytes,
      @ForAll("names") String robot) {
    WireWriter out = new WireWriter();
    out.u8(u8);
    out.bool(bool);
    out.u16(u16);
    out.i32(i32);
    out.i64(i64);
    out.f64(f64);
    out.bytes(bytes);
    out.robot(new RobotId(robot));
    ProcessId process = new ProcessId(new RobotId(robot), Math.max(1, i64));
    out.process(process);

    WireReader in = new WireReader();
    in.reset(out.buffer(), 0, out.length());
    assertThat(in.u8()).isEqualTo(u8);
    assertThat(in.bool()).isEqualTo(bool);
    assertThat(in.u16()).isEqualTo(u16);
    assertThat(in.i32()).isEqualTo(i32);
    assertThat(in.i64()).isEqualTo(i64);
    assertThat(in.f64()).isEqualTo(f64);
    assertThat(in.bytes()).isEqualTo(bytes);
    assertThat(in.robot()).isEqualTo(new RobotId(robot));
    assertThat(in.process()).isEqualTo(process);
    in.expectEnd();
  }

  @Property
  void everyStringIsReadBackOrRefused(@ForAll @Size(max = 260) String text) {
    byte[] buffer = new byte[256];
    WireWriter out = new WireWriter(buffer);
    try {
      out.string(text);
    } catch (IllegalArgumentException refused) {
      String roundTrip =
          new String(
              text.getBytes(java.nio.charset.StandardCharsets.UTF_8),
              java.nio.charset.StandardCharsets.UTF_8);
      boolean hasHalfAPair = !roundTrip.equals(text);
      int bytes = text.getBytes(java.nio.charset.StandardCharsets.UTF_8).length;
      assertThat(hasHalfAPair || bytes > 255).isTrue();
      return;
    }
    WireReader in = new WireReader();
    in.reset(buffer, 0, out.length());
    assertThat(in.string()).isEqualTo(text);
    in.expectEnd();
  }

  @Property
  void invalidBytesCauseOnlyAWireFormatException(
      @ForAll @Size(max = 40) byte[] bytes, @ForAll @IntRange(max = 9) int field) {
    WireReader in = new WireReader(bytes);
    try {
      read(in, field);
    } catch (WireFormatException refused) {
      return;
    }
    assertThat(in.remaining()).isBetween(0, bytes.length - 1);
  }

  private static Object read(WireReader in, int field) {
    return switch (field) {
      case 0 -> in.u8();
      case 1 -> in.bool();
      case 2 -> in.u16();
      case 3 -> in.i32();
      case 4 -> in.i64();
      case 5 -> in.f64();
      case 6 -> in.string();
      case 7 -> in.bytes();
      case 8 -> in.robot();
      default -> in.process();
    };
  }

  @Property
  void valuesThatDoNotFitAreRefused(@ForAll int value) {
    Assume.that(value < 0 || value > 0xFFFF);
    WireWriter out = new WireWriter(new byte[4]);

    assertThatIllegalArgumentException().isThrownBy(() -> out.u8(value));
    assertThatIllegalArgumentException().isThrownBy(() -> out.u16(value));
    assertThatIllegalArgumentException().isThrownBy(() -> out.i64(value));
    assertThatIllegalArgumentException().isThrownBy(() -> out.string("12345"));
    assertThat(out.length()).isZero();
  }

  @Test
  void nonFiniteNumbersAreRefusedByReaderAndWriter() {
    WireWriter out = new WireWriter();
    assertThatIllegalArgumentException().isThrownBy(() -> out.f64(Double.NaN));
    assertThatIllegalArgumentException().isThrownBy(() -> out.f64(1.0 / 0));
    out.i64(Double.doubleToLongBits(Double.NEGATIVE_INFINITY));
    WireReader in = new WireReader(out.buffer());
    assertThatExceptionOfType(WireFormatException.class).isThrownBy(in::f64);
  }

  @Test
  void aStringOfBytesThatAreNoUtf8IsRefused() {
    WireReader in = new WireReader(new byte[] {2, (byte) 0xC3, 'x'});
    assertThatExceptionOfType(WireFormatException.class).isThrownBy(in::string);
  }
}
