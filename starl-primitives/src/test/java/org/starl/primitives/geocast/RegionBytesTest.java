package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.util.Arrays;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
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
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class RegionBytesTest {

  private final Shape<Region> shape = RegionBytes.SHAPE;

  @Provide
  Arbitrary<Region> regions() {
    Arbitrary<Double> number = Arbitraries.doubles().between(-1e7, 1e7);
    Arbitrary<Double> size = Arbitraries.doubles().between(0.5, 1e5);
    Arbitrary<Point> point = Combinators.combine(number, number).as(Point::new);
    Arbitrary<Region> simple =
        Arbitraries.oneOf(
            Arbitraries.of(new Nowhere(), new Everywhere()),
            Combinators.combine(point, size).as(Circle::new),
            Combinators.combine(point, size, size).as(Rectangle::around),
            Combinators.combine(point, size, size)
                .as((p, w, h) -> Polygon.of(p, p.plus(new Point(w, 0)), p.plus(new Point(0, h)))));
    Arbitrary<Region> unions = simple.list().ofMinSize(1).ofMaxSize(4).map(Union::new);
    Arbitrary<Region> nested =
        Combinators.combine(unions, simple).as((union, other) -> Union.of(union, other));
    return Arbitraries.oneOf(simple, unions, nested);
  }

  @Property
  void aRegionIsReadAsItWasWritten(@ForAll("regions") Region region) {
    WireReader reader = new WireReader(bytes(region));
    assertThat(shape.read(reader)).isEqualTo(region);
    assertThat(reader.remaining()).isZero();
  }

  @Property
  void theJsonOfARegionIsReadAsItWasWritten(@ForAll("regions") Region region)
      throws JsonFormatException {
    assertThat(shape.readJson(new JsonReader("", 1, shape.json(region)))).isEqualTo(region);
  }

  @Property
  void theTraceTextOfARegionIsExact(@ForAll("regions") Region region) {
    assertThat(RegionText.parse(RegionText.format(region))).isEqualTo(region);
  }

  @Property
  void otherBytesAreRefused(@ForAll byte[] bytes) {
    WireReader reader = new WireReader(bytes);
    try {
      assertThat(shape.read(reader)).isNotNull();
    } catch (WireFormatException e) {
      assertThat(e.getMessage()).isNotBlank();
    }
  }

  @Property
  void aTruncatedRegionIsRefused(@ForAll("regions") Region region) {
    byte[] bytes = bytes(region);
    for (int length = 0; length < bytes.length; length++) {
      WireReader reader = new WireReader(Arrays.copyOf(bytes, length));
      assertThatThrownBy(() -> shape.read(reader)).isInstanceOf(WireFormatException.class);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "square(1 2)", "circle(1 2)", "nowhere)", "circle(1 2 x)", "union(nowhere"})
  void otherTextIsNoRegion(String text) {
    assertThatThrownBy(() -> RegionText.parse(text)).isInstanceOf(IllegalArgumentException.class);
  }

  @Property
  void messagesAreReadAsTheyWereWritten(@ForAll("regions") Region region, @ForAll boolean ack) {
    GeocastId id = new GeocastId(new ProcessId(new RobotId("bot7"), 1L << 32), 9);
    GeocastMessage<Integer> message =
        ack ? new GeocastMessage.Ack<>(id) : new GeocastMessage.Copy<>(id, region, 5, 6, 3);
    Shape<GeocastMessage<Integer>> messages = GeocastMessage.shape(Shapes.U8);
    byte[] buffer = new byte[1_400];
    WireWriter writer = new WireWriter(buffer);
    messages.write(message, writer);
    WireReader reader = new WireReader(Arrays.copyOf(buffer, writer.length()));
    assertThat(messages.read(reader)).isEqualTo(message);
    assertThat(reader.remaining()).isZero();
  }

  @Test
  void aGeocastWithoutANumberIsRefused() {
    Shape<GeocastMessage<Integer>> messages = GeocastMessage.shape(Shapes.U8);
    byte[] buffer = new byte[100];
    WireWriter writer = new WireWriter(buffer);
    messages.write(
        new GeocastMessage.Ack<>(new GeocastId(new ProcessId(new RobotId("bot7"), 1L << 32), 1)),
        writer);
    buffer[writer.length() - 1] = 0;
    assertThatThrownBy(() -> messages.read(new WireReader(Arrays.copyOf(buffer, writer.length()))))
        .isInstanceOf(WireFormatException.class)
        .hasMessage("geocast number 0");
  }

  @Test
  void anIntervalBeginsAtZeroOrLaterAndIsNotEmpty() {
    assertThat(intervalIsRead(0, 1)).isTrue();
    assertThat(intervalIsRead(4, 4)).isFalse();
    assertThat(intervalIsRead(-1, 4)).isFalse();
  }

  /** A message ends with its interval, two times of eight bytes, and here a payload of one byte. */
  private static boolean intervalIsRead(long startNs, long deadlineNs) {
    Shape<GeocastMessage<Integer>> messages = GeocastMessage.shape(Shapes.U8);
    GeocastId id = new GeocastId(new ProcessId(new RobotId("bot7"), 1L << 32), 1);
    GeocastMessage<Integer> copy = new GeocastMessage.Copy<>(id, new Everywhere(), 5, 6, 3);
    byte[] bytes = WireWriter.toBytes(out -> messages.write(copy, out));
    ByteBuffer.wrap(bytes)
        .putLong(bytes.length - 17, startNs)
        .putLong(bytes.length - 9, deadlineNs);
    try {
      messages.read(new WireReader(bytes));
      return true;
    } catch (WireFormatException refused) {
      return false;
    }
  }

  private byte[] bytes(Region region) {
    byte[] buffer = new byte[1_400];
    WireWriter writer = new WireWriter(buffer);
    shape.write(region, writer);
    return Arrays.copyOf(buffer, writer.length());
  }
}
