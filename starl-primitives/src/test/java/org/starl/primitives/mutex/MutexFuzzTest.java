package org.starl.primitives.mutex;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.primitives.membership.Sections;
import org.starl.shape.Shape;
import org.starl.sim.check.MalformedBytes;

/** Decodes arbitrary bytes as a mutex message. */
public class MutexFuzzTest {

  private static final Shape<MutexMessage> CODEC = MutexMessage.SHAPE;

  public static void fuzzerTestOneInput(byte[] input) {
    OneSpelling.require(CODEC, input);
  }

  @Test
  void aMessageHasOneEncoding() {
    ProcessId one = ProcessId.first(new RobotId("one"), 1);
    ProcessId two = new ProcessId(new RobotId("two"), 1L << 32);
    var sections = Sections.copyOf(List.of("A", "B:1", "C-2"));
    List<byte[]> samples = new ArrayList<>();
    List.of(
            new MutexMessage.Req(one, two, 1, 2, 3, sections),
            new MutexMessage.Ok(one, two, 4),
            new MutexMessage.Rem(one, two, 5, sections),
            new MutexMessage.Noted(one, two, 6),
            new MutexMessage.FenceQ(one, two, ProcessId.first(new RobotId("c"), 7), 8),
            new MutexMessage.Fence(one, two, ProcessId.first(new RobotId("c"), 7), sections),
            new MutexMessage.Fenced(one, two))
        .forEach(message -> samples.add(OneSpelling.bytes(CODEC, message)));

    MalformedBytes.feed(samples, MutexFuzzTest::fuzzerTestOneInput);
  }
}
