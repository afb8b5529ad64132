package org.starl.primitives.geocast;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.RegionText;
import org.starl.geometry.Union;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.sim.check.MalformedBytes;

/**
 * Decodes arbitrary bytes as a message of a geocast: a decoded region is usable, and has one
 * encoding on the wire and in the trace.
 */
public class GeocastFuzzTest {

  private static final Shape<GeocastMessage<String>> MESSAGE = GeocastMessage.shape(Shapes.TEXT);

  public static void fuzzerTestOneInput(byte[] input) {
    OneSpelling.require(MESSAGE, input);
    OneSpelling.require(RegionBytes.SHAPE, input);
    Region region;
    try {
      region = RegionBytes.SHAPE.read(new WireReader(input));
    } catch (WireFormatException refused) {
      return;
    }
    region.contains(new Point(1, 2));
    region.contains(new Point(Double.MAX_VALUE, -Double.MAX_VALUE));
    if (!RegionText.parse(RegionText.format(region)).equals(region)) {
      throw new AssertionError("told otherwise: " + RegionText.format(region));
    }
  }

  @Test
  void aMessageHasOneEncoding() {
    GeocastId id = new GeocastId(ProcessId.first(new RobotId("one"), 1), 7);
    Region square = new Polygon(List.of(new Point(0, 0), new Point(9, 0), new Point(9, 9)));
    Region area =
        new Union(
            List.of(
                new Circle(new Point(1, -2.5), 300),
                new Union(List.of(new Rectangle(0, 0, 10, 20), new Nowhere())),
                square));
    List<byte[]> samples = new ArrayList<>();
    samples.add(
        OneSpelling.bytes(MESSAGE, new GeocastMessage.Copy<>(id, new Everywhere(), 0, 5, "hi")));
    samples.add(OneSpelling.bytes(MESSAGE, new GeocastMessage.Copy<>(id, area, 4, 5, "hi")));
    samples.add(OneSpelling.bytes(MESSAGE, new GeocastMessage.Ack<>(id)));
    samples.add(OneSpelling.bytes(RegionBytes.SHAPE, area));

    MalformedBytes.feed(samples, GeocastFuzzTest::fuzzerTestOneInput);
  }
}
