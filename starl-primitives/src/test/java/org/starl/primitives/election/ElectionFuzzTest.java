package org.starl.primitives.election;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as an election message. */
public class ElectionFuzzTest {

  public static void fuzzerTestOneInput(byte[] input) {
    OneSpelling.require(ElectionMessage.SHAPE, input);
  }

  @Test
  void equalMessagesHaveEqualBytes() {
    ProcessId one = ProcessId.first(new RobotId("one"), 1);
    List<byte[]> samples = new ArrayList<>();
    List.of(
            new ElectionMessage.Candidacy(one, 7, -2),
            new ElectionMessage.Elected(one, 8, ProcessId.first(new RobotId("two"), 9)))
        .forEach(message -> samples.add(OneSpelling.bytes(ElectionMessage.SHAPE, message)));

    MalformedBytes.feed(samples, ElectionFuzzTest::fuzzerTestOneInput);
  }
}
