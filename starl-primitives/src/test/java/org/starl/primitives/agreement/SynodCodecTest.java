package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.TreeMap;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.comms.Codec;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.platform.Radio;
import org.starl.primitives.OneSpelling;
import org.starl.primitives.agreement.SynodMessage.Accept;
import org.starl.primitives.agreement.SynodMessage.Accepted;
import org.starl.primitives.agreement.SynodMessage.Decided;
import org.starl.primitives.agreement.SynodMessage.Nack;
import org.starl.primitives.agreement.SynodMessage.Prepare;
import org.starl.primitives.agreement.SynodMessage.Promise;
import org.starl.primitives.agreement.SynodMessage.Query;
import org.starl.primitives.agreement.SynodMessage.Vote;
import org.starl.shape.JsonFormatException;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class SynodCodecTest {

  private static final SynodCodec.Format ANYTHING =
      new SynodCodec.Format() {
        @Override
        public void checkValue(long number, Value value) {
          // Any bytes will do here.
        }

        @Override
        public void checkWish(Value wish) {
          // Any bytes will do here.
        }
      };

  @Test
  void aValueThatTheCodecCannotReadIsRefused() {
    Shape<SynodMessage> texts = SynodCodec.of(SynodCodec.Format.of(Codec.text()));
    assertThat(texts.read(new WireReader(decided((byte) 'a')))).isInstanceOf(Decided.class);
    assertThatThrownBy(() -> texts.read(new WireReader(decided((byte) 0xFF))))
        .isInstanceOf(WireFormatException.class)
        .hasMessage("a string that is not UTF-8");
    Shape<SynodMessage> flags =
        SynodCodec.of(SynodCodec.Format.of(Codec.of((b, out) -> out.bool(b), WireReader::bool)));
    assertThatThrownBy(() -> flags.read(new WireReader(decided((byte) 1, (byte) 1))))
        .isInstanceOf(WireFormatException.class)
        .hasMessage("1 bytes after a value");
  }

  private static byte[] decided(byte... value) {
    return WireWriter.toBytes(
        out -> SynodCodec.of(ANYTHING).write(new Decided(1, Value.of(value)), out));
  }

  private final Shape<SynodMessage> codec = SynodCodec.of(ANYTHING);

  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void everyMessageIsReadAsItWasWritten(@ForAll("messages") SynodMessage message) {
    WireReader in = new WireReader(bytes(message));
    assertThat(codec.read(in)).isEqualTo(message);
    assertThat(in.remaining()).isZero();
  }

  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void everyMessageOfATraceIsReadAsItWasWritten(@ForAll("messages") SynodMessage message)
      throws JsonFormatException {
    assertThat(OneSpelling.fromJson(SynodMessage.SHAPE, codec.json(message))).isEqualTo(message);
  }

  /** The bytes of {@code docs/wire-format.md}, Synod messages. */
  @Test
  void theBytesAreAsDocumented() {
    Ballot one = new Ballot(3, new ProcessId(new RobotId("b1"), 5));
    Ballot two = new Ballot(4, new ProcessId(new RobotId("b2"), 6));
    String number = "0000000000000007";
    String first = "0000000000000003" + "026231" + "0000000000000005";
    String second = "0000000000000004" + "026232" + "0000000000000006";
    Value value = Value.of(new byte[] {1, -1});
    assertThat(hex(new Prepare(7, one, value))).isEqualTo("01" + number + first + "0002" + "01ff");
    assertThat(hex(new Promise(7, two, new Vote(one, value), List.of())))
        .isEqualTo("02" + number + second + "01" + first + "0002" + "01ff" + "00");
    assertThat(hex(new Promise(7, two, null, List.of(value, Value.EMPTY))))
        .isEqualTo("02" + number + second + "00" + "02" + "0002" + "01ff" + "0000");
    assertThat(hex(new Nack(7, one, two))).isEqualTo("03" + number + first + second);
    assertThat(hex(new Accept(7, one, value))).isEqualTo("04" + number + first + "0002" + "01ff");
    assertThat(hex(new Accepted(7, one))).isEqualTo("05" + number + first);
    assertThat(hex(new Decided(7, value))).isEqualTo("06" + number + "0002" + "01ff");
    assertThat(hex(new Query(7))).isEqualTo("07" + number);
  }

  @Test
  void otherBytesAreRefused() {
    byte[] accepted = bytes(new Accepted(1, new Ballot(1, new ProcessId(new RobotId("a"), 1))));
    for (int at : new int[] {0, 8, 16}) {
      byte[] zero = accepted.clone();
      zero[at] = 0; // the kind, the number, the round
      assertThatThrownBy(() -> codec.read(new WireReader(zero)))
          .isInstanceOf(WireFormatException.class);
    }
    byte[] tooLong =
        WireWriter.toBytes(out -> {
          out.u8(6);
          out.i64(1);
          out.bytes(new byte[Value.MAX_BYTES + 1]);
        });
    assertThatThrownBy(() -> codec.read(new WireReader(tooLong)))
        .isInstanceOf(WireFormatException.class)
        .hasMessageStartingWith("a value of 1001 bytes");
  }

  @Test
  void aValueInATraceIsItsHexadecimalDigits() throws JsonFormatException {
    String decided = "{\"Decided\":{\"number\":1,\"value\":\"01ff\"}}";
    assertThat(codec.json(new Decided(1, Value.of(new byte[] {1, -1})))).isEqualTo(decided);
    assertThat(OneSpelling.fromJson(SynodMessage.SHAPE, decided))
        .isEqualTo(new Decided(1, Value.of(new byte[] {1, -1})));
    for (String other : List.of("01f", "01FF", "01fg", "0x01", "é1")) {
      assertThatThrownBy(
              () -> OneSpelling.fromJson(SynodMessage.SHAPE, decided.replace("01ff", other)))
          .isInstanceOf(JsonFormatException.class)
          .hasMessageContaining("hexadecimal digits");
    }
  }

  /** The channel's own condition holds for a trace as well. */
  @Test
  void aMalformedValueInATraceIsRefused() {
    Shape<SynodMessage> flags = SynodCodec.of(SynodCodec.Format.of(Shapes.BOOL));
    String decided = "{\"Decided\":{\"number\":1,\"value\":\"02\"}}";
    assertThatThrownBy(() -> OneSpelling.fromJson(flags, decided))
        .isInstanceOf(JsonFormatException.class)
        .hasMessageContaining("boolean 2");
  }

  private String hex(SynodMessage message) {
    return HexFormat.of().formatHex(bytes(message));
  }

  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void damagedBytesAreReadOrRefused(@ForAll("messages") SynodMessage message, @ForAll long seed) {
    byte[] damaged = bytes(message);
    int at = (int) Math.floorMod(seed, (long) damaged.length);
    damaged[at] ^= (byte) (1 + Math.floorMod(seed >> 8, 255L));
    readsOrRefuses(damaged);
    readsOrRefuses(Arrays.copyOf(damaged, at));
  }

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void anAcceptorsRecordIsReadAsItWasWritten(
      @ForAll("messages") SynodMessage one, @ForAll("messages") SynodMessage other) {
    AcceptorRecord record = recordOf(one, other);
    assertThat(AcceptorRecord.fromBytes(record.toBytes())).isEqualTo(record);
  }

  /** A robot with a new program reads what the old one has stored. */
  @Test
  void theBytesOfARecordNeverChange() {
    Ballot one = new Ballot(3, new ProcessId(new RobotId("b1"), 5));
    String ballot = "0000000000000003" + "026231" + "0000000000000005";
    Value value = Value.of(new byte[] {1, -1});
    TreeMap<Long, AcceptorRecord.Slot> slots = new TreeMap<>();
    slots.put(8L, new AcceptorRecord.Slot(one, null));
    slots.put(9L, new AcceptorRecord.Slot(one, new Vote(one, value)));
    assertThat(AcceptorRecord.NEW.toBytes()).containsExactly(1, 0, 0, 0);
    assertThat(HexFormat.of().formatHex(new AcceptorRecord(new Decided(7, value), slots).toBytes()))
        .isEqualTo(
            ("01" + "01" + "0000000000000007" + "0002" + "01ff" + "0002")
                + ("0000000000000008" + ballot + "00")
                + ("0000000000000009" + ballot + "01" + ballot + "0002" + "01ff"));
  }

  @Test
  void aDamagedRecordIsRefused() {
    byte[] bytes = recordOf(new Decided(3, Value.EMPTY), new Query(0)).toBytes();
    assertThatThrownBy(() -> AcceptorRecord.fromBytes(Arrays.copyOf(bytes, bytes.length - 1)))
        .isInstanceOf(WireFormatException.class);
    assertThatThrownBy(() -> AcceptorRecord.fromBytes(Arrays.copyOf(bytes, bytes.length + 1)))
        .isInstanceOf(WireFormatException.class);
  }

  @Test
  void onlyAQueryIsOfNumberZeroAndOnlyAFormatWithWishesHasThem() {
    assertThat(codec.read(new WireReader(bytes(new Query(0))))).isEqualTo(new Query(0));
    Ballot ballot = new Ballot(1, new ProcessId(new RobotId("a"), 1));
    byte[] zero = bytes(new Accepted(0, ballot));
    assertThatThrownBy(() -> codec.read(new WireReader(zero)))
        .isInstanceOf(WireFormatException.class);
    byte[] wish = bytes(new Prepare(1, ballot, Value.of(new byte[1])));
    Shape<SynodMessage> withoutWishes = SynodCodec.of((number, value) -> {});
    assertThatThrownBy(() -> withoutWishes.read(new WireReader(wish)))
        .isInstanceOf(WireFormatException.class);
  }

  @Test
  void theLongestMessageFitsADatagram() {
    Ballot ballot = new Ballot(1, new ProcessId(new RobotId("a".repeat(32)), 1));
    Value longest = Value.of(new byte[Value.MAX_BYTES]);
    Promise promise = new Promise(1, ballot, new Vote(ballot, longest), List.of());
    assertThat(bytes(promise)).hasSizeLessThan(Radio.MAX_BYTES - 250);
  }

  private void readsOrRefuses(byte[] bytes) {
    try {
      assertThat(codec.read(new WireReader(bytes))).isNotNull();
    } catch (WireFormatException refused) {
      assertThat(refused).hasMessageMatching(".+");
    }
  }

  private byte[] bytes(SynodMessage message) {
    byte[] buffer = new byte[4 * Radio.MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    codec.write(message, out);
    return Arrays.copyOf(buffer, out.length());
  }

  private static AcceptorRecord recordOf(SynodMessage one, SynodMessage other) {
    TreeMap<Long, AcceptorRecord.Slot> slots = new TreeMap<>();
    for (SynodMessage message : List.of(one, other)) {
      if (message instanceof Promise m) {
        slots.put(m.number(), new AcceptorRecord.Slot(m.ballot(), m.vote()));
      }
    }
    return new AcceptorRecord(one instanceof Decided decided ? decided : null, slots);
  }

  @Provide
  Arbitrary<SynodMessage> messages() {
    Arbitrary<Long> numbers = Arbitraries.longs().greaterOrEqual(1);
    Arbitrary<Ballot> ballots =
        Combinators.combine(numbers, Arbitraries.integers().between(0, 99), numbers)
            .as((round, bot, inc) -> new Ballot(round, new ProcessId(new RobotId("b" + bot), inc)));
    Arbitrary<Value> values =
        Arbitraries.bytes().array(byte[].class).ofMaxSize(Value.MAX_BYTES).map(Value::of);
    Arbitrary<List<Value>> wishes =
        Arbitraries.bytes().array(byte[].class).ofMaxSize(30).map(Value::of).list().ofMaxSize(10);
    Arbitrary<@Nullable Vote> votes = Combinators.combine(ballots, values).as(Vote::new);
    return Arbitraries.oneOf(
        Combinators.combine(numbers, ballots, values).as(Prepare::new),
        Combinators.combine(numbers, ballots, votes.injectNull(0.3), wishes)
            .as((n, b, v, w) -> new Promise(n, b, v, new ArrayList<>(w))),
        Combinators.combine(numbers, ballots, ballots).as(Nack::new),
        Combinators.combine(numbers, ballots, values).as(Accept::new),
        Combinators.combine(numbers, ballots).as(Accepted::new),
        Combinators.combine(numbers, values).as(Decided::new),
        numbers.map(Query::new));
  }
}
