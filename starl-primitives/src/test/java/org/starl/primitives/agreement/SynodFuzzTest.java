package org.starl.primitives.agreement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.ProcessId;
import org.starl.RobotId;
import org.starl.comms.WireReader;
import org.starl.primitives.OneSpelling;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a message of the Synod, and as an acceptor's record. */
public class SynodFuzzTest {

  private static final SynodCodec CODEC = new SynodCodec(SynodCodec.Format.anyValueNoWish());

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

  @Test
  void aMessageHasOneSpelling() {
    Ballot ballot = new Ballot(3, new ProcessId(new RobotId("one"), 5));
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
