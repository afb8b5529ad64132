package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.sim.check.MalformedBytes;

/** Decodes arbitrary bytes as a message about tubes. */
public class TubeFuzzTest {

  public static void fuzzerTestOneInput(byte[] input) {
    OneSpelling.require(TubeMessage.SHAPE, input);
  }

  @Test
  void aMessageHasOneEncoding() {
    Tube tube = new Tube(List.of(new Point(1, 2), new Point(-300, 4), new Point(5, -600)), 250);
    Holding holding = new Holding(7L << 32, List.of(tube, tube), List.of(tube));
    List<byte[]> samples = new ArrayList<>();
    List.of(
            new TubeMessage.Ask(holding),
            new TubeMessage.Vote(8),
            new TubeMessage.Refuse(9, new RobotId("one"), holding),
            new TubeMessage.Refuse(9, new RobotId("one"), Holding.NONE))
        .forEach(message -> samples.add(OneSpelling.bytes(TubeMessage.SHAPE, message)));

    MalformedBytes.feed(samples, TubeFuzzTest::fuzzerTestOneInput);
  }
}
