package org.starl.primitives.election;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.HexFormat;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.election.ElectionMessage.Candidacy;
import org.starl.primitives.election.ElectionMessage.Elected;
import org.starl.shape.JsonFormatException;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class ElectionCodecTest {

  private static final Shape<ElectionMessage> CODEC = ElectionMessage.SHAPE;
  private static final ProcessId B1 = new ProcessId(new RobotId("b1"), 5);
  private static final ProcessId B2 = new ProcessId(new RobotId("b2"), 6);

  /** The bytes of {@code docs/wire-format.md}, Election messages. */
  @Test
  void theBytesAreAsDocumented() {
    assertThat(hex(new Candidacy(B1, 7, -2)))
        .isEqualTo("01" + "026231" + "0000000000000005" + "0000000000000007" + "fffffffffffffffe");
    assertThat(hex(new Elected(B1, 7, B2)))
        .isEqualTo(
            "02"
                + "026231"
                + "0000000000000005"
                + "0000000000000007"
                + "026232"
                + "0000000000000006");
    assertThat(HexFormat.of().formatHex(ElectionProtocol.toValue(B2).bytes()))
        .isEqualTo("026232" + "0000000000000006");
  }

  @Property(tries = 100)
  void writtenMessagesAreReadBack(
      @ForAll @LongRange(min = 1) long term, @ForAll long draw, @ForAll boolean isCandidacy)
      throws JsonFormatException {
    ElectionMessage message =
        isCandidacy ? new Candidacy(B1, term, draw) : new Elected(B1, term, B2);
    assertThat(CODEC.read(new WireReader(bytes(message)))).isEqualTo(message);
    assertThat(OneSpelling.fromJson(CODEC, CODEC.json(message))).isEqualTo(message);
  }

  @Test
  void malformedMessagesAreRefused() {
    byte[] termZero = bytes(new Candidacy(B1, 1, 2));
    termZero[19] = 0;
    byte[] otherKind = bytes(new Candidacy(B1, 1, 2));
    otherKind[0] = 3;
    for (byte[] bad : new byte[][] {termZero, otherKind, {1}, {}}) {
      assertThatThrownBy(() -> CODEC.read(new WireReader(bad)))
          .isInstanceOf(WireFormatException.class);
    }
  }

  @Test
  void onlyALeaderIsAValueAndWishesAreEmpty() {
    SynodCodec.Format leaders = SynodCodec.Format.of(Shapes.PROCESS);
    leaders.checkValue(1, ElectionProtocol.toValue(B1));
    leaders.checkWish(Value.EMPTY);
    byte[] tooLong = Arrays.copyOf(ElectionProtocol.toValue(B1).bytes(), 12);
    assertThatThrownBy(() -> leaders.checkValue(1, Value.of(tooLong)))
        .isInstanceOf(WireFormatException.class);
    assertThatThrownBy(() -> leaders.checkValue(1, Value.EMPTY))
        .isInstanceOf(WireFormatException.class);
    assertThatThrownBy(() -> leaders.checkWish(ElectionProtocol.toValue(B1)))
        .isInstanceOf(WireFormatException.class);
  }

  private static String hex(ElectionMessage message) {
    return HexFormat.of().formatHex(bytes(message));
  }

  private static byte[] bytes(ElectionMessage message) {
    byte[] buffer = new byte[100];
    WireWriter out = new WireWriter(buffer);
    CODEC.write(message, out);
    return Arrays.copyOf(buffer, out.length());
  }
}
