package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.comms.Codec;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.shape.Json;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;

/** What a reader of traces gets. */
class GeocastFactTest {

  private static final ProcessId ME = ProcessId.first(new RobotId("bot0"), 1);
  private static final GeocastId ID = new GeocastId(ME, 7);
  private static final Region AREA = new Circle(new Point(1, -2.5), 300);

  private static <T> T reread(Shape<T> shape, T value) throws JsonFormatException {
    return read(shape, shape.json(value));
  }

  private static <T> T read(Shape<T> shape, String json) throws JsonFormatException {
    JsonReader in = new JsonReader("a.trace", 1, json);
    T value = shape.readJson(in);
    in.expectEnd();
    return value;
  }

  @Test
  void aFactIsReadAsItWasWritten() throws JsonFormatException {
    for (GeocastFact fact :
        List.of(
            new GeocastFact.Opened(ME),
            new GeocastFact.do_geocast(ID, AREA, 5),
            new GeocastFact.BCast(ID, new Everywhere(), 5),
            new GeocastFact.copy(ID),
            new GeocastFact.deliver(ID),
            new GeocastFact.dismiss(ID, Dismissal.LATE, 12.5),
            new GeocastFact.dismiss(ID, Dismissal.OUTSIDE, Double.POSITIVE_INFINITY))) {
      assertThat(reread(GeocastFact.SHAPE, fact)).isEqualTo(fact);
    }
  }

  @Test
  void aMessageIsReadWithItsTags() throws JsonFormatException {
    Shape<GeocastMessage<String>> text = GeocastMessage.shape(Shapes.TEXT);
    GeocastMessage<String> copy = new GeocastMessage.Copy<>(ID, AREA, 0, 5, "hi");
    assertThat(reread(text, copy)).isEqualTo(copy);
    assertThat(reread(text, new GeocastMessage.Ack<>(ID)))
        .isEqualTo(new GeocastMessage.Ack<String>(ID));
  }

  /** Also if the app's messages are bytes alone. */
  @Test
  void aReaderThatDoesNotKnowTheAppReadsTheTags() throws JsonFormatException {
    Codec<String> bytes = Codec.of((text, out) -> out.string(text), in -> in.string());
    String json = GeocastMessage.shape(bytes).json(new GeocastMessage.Copy<>(ID, AREA, 0, 5, "hi"));
    for (String kind : List.of("geocast", "broadcast")) {
      assertThat(read(GeocastFact.VOCABULARY.message(Instance.of(kind, "x")), json))
          .isEqualTo(new GeocastMessage.Copy<>(ID, AREA, 0, 5, new Json("\"hi\"")));
    }
  }

  @Test
  void theTextsForPeopleAreShort() {
    GeocastFact dismissed = new GeocastFact.dismiss(ID, Dismissal.OUTSIDE, 12.5);
    assertThat(GeocastFact.SHAPE.caseOf(dismissed).values(dismissed))
        .hasToString("[bot0/7, outside, 12.5]");
  }

  @Test
  void theTheoryTakesTheStartTheDeliveriesAndTheRestarts() {
    RobotId robot = new RobotId("bot1");
    Area area = new Area("bot0/7");
    assertThat(GeocastFact.action(new GeocastFact.do_geocast(ID, AREA, 5), robot))
        .isEqualTo(new GeocastAction.do_geocast("bot0/7", area, 5));
    assertThat(GeocastFact.action(new GeocastFact.BCast(ID, AREA, 5), robot))
        .isEqualTo(new GeocastAction.do_geocast("bot0/7", area, 5));
    assertThat(GeocastFact.action(new GeocastFact.deliver(ID), robot))
        .isEqualTo(new GeocastAction.deliver("bot0/7", robot));
    assertThat(GeocastFact.action(new GeocastFact.Opened(ME), robot))
        .isEqualTo(new GeocastAction.restart(robot));
    assertThat(GeocastFact.action(new GeocastFact.copy(ID), robot)).isNull();
    assertThat(GeocastFact.action(new GeocastFact.dismiss(ID, Dismissal.EARLY, 1), robot)).isNull();
  }
}
