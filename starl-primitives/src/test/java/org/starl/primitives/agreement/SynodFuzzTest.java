package org.starl.primitives.agreement;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a message of the Synod, and as an acceptor's record. */
public class SynodFuzzTest {

  private static final Shape<SynodMessage> CODEC = SynodCodec.of((number, value) -> {});

  public static void fuzzerTestOneInput(byte[] input) {
    OneSpelling.require(CODEC, input);
    OneSpelling.require(SynodFuzzTest::record, AcceptorRecord::toBytes, input);
  }

  private static AcceptorRecord record(WireReader in) {
    byte[] all = new byte[in.remaining()];
    for (int i = 0; i < all.length; i++) {
      all[i] = (byte) in.u8();
    }
    return AcceptorRecord.fromBytes(all);
  }

  /** An acceptor's slots in any order were read all the same. */
  @Test
  void aRecordInAnotherOrderIsRefused() {
    String hex =
        "01010000000000000006000301020300022f00000000001a92764f000000000003036f6e6500000000000000050100"
            + "00000000000003036f6e6500000000000000050003010203000000000000000900004d2e00000003036f6e65"
            + "000000000000000500";

    assertThatThrownBy(() -> AcceptorRecord.fromBytes(HexFormat.of().parseHex(hex)))
        .isInstanceOf(WireFormatException.class)
        .hasMessageContaining("9 after ");
  }

  @Test
  void equalMessagesHaveEqualBytes() {
    Ballot ballot = new Ballot(3, ProcessId.first(new RobotId("one"), 5));
    Value value = Value.of(new byte[] {1, 2, 3});
    SynodMessage.Vote vote = new SynodMessage.Vote(ballot, value);
    List<byte[]> samples = new ArrayList<>();
    Arrays.<SynodMessage>asList(
            new SynodMessage.Prepare(1, ballot, Value.EMPTY),
            new SynodMessage.Promise(2, ballot, vote, List.of()),
            new SynodMessage.Promise(2, ballot, null, List.of(Value.EMPTY)),
            new SynodMessage.Nack(3, ballot, ballot),
            new SynodMessage.Accept(4, ballot, value),
            new SynodMessage.Accepted(5, ballot),
            new SynodMessage.Decided(6, value),
            new SynodMessage.Query(0))
        .forEach(message -> samples.add(OneSpelling.bytes(CODEC, message)));
    samples.add(AcceptorRecord.NEW.toBytes());
    samples.add(
        new AcceptorRecord(
                new SynodMessage.Decided(6, value),
                new TreeMap<>(
                    Map.of(
                        7L,
                        new AcceptorRecord.Slot(ballot, vote),
                        9L,
                        new AcceptorRecord.Slot(ballot, null))))
            .toBytes());

    MalformedBytes.feed(samples, SynodFuzzTest::fuzzerTestOneInput);
  }
}
