package org.starl.apps.search.logic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.id.RobotId;
import org.starl.platform.Sighting;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

/** What a search tells its trace: as text for people, and as JSON. */
class SearchFactTest {

  private static final RobotId BOT = new RobotId("bot1");

  static List<Answer> answers() {
    return List.of(
        Answer.NOTHING,
        Answer.nothing(List.of("A")),
        Answer.nothing(List.of("a room", "B")),
        Answer.nothing(Collections.nCopies(Report.MAX_ROOMS, "room 200")),
        Answer.found("", new Point(0, 0), BOT),
        Answer.found("a thing at 1,2 by bot4", new Point(-3, 4), BOT));
  }

  @ParameterizedTest
  @MethodSource("answers")
  void anAnswerIsReadAsItWasWritten(Answer answer) {
    byte[] bytes = WireWriter.toBytes(out -> Answer.SHAPE.write(answer, out));
    assertThat(Answer.SHAPE.read(new WireReader(bytes))).isEqualTo(answer);
  }

  @Test
  void anAnswerOfNoKindIsRefused() {
    assertThatThrownBy(() -> Answer.SHAPE.read(new WireReader(new byte[] {4})))
        .isInstanceOf(WireFormatException.class);
  }

  @Test
  void anAnswerNamesWhatWasFoundAndWhatWasGivenUp() {
    assertThat(Answer.found("a thing", new Point(3.2, -4.4), BOT))
        .hasToString("found a thing at 3,-4 by bot1");
    assertThat(Answer.nothing(List.of("A", "B"))).hasToString("gave up, could not search A B");
    assertThat(Answer.nothing(List.of())).hasToString("nothing there");
  }

  @Test
  void aPlaceIsToldInWholeMmAndItsErrorOnlyOfAnInexactSensor() {
    Sighting exact = new Sighting("object", new Point(1.6, -2.4), 0);
    assertThat(SearchFact.Found.of(exact, 7)).isEqualTo(new SearchFact.Found("object", 2, -2, 0));
    Sighting inexact = new Sighting("object", new Point(1.6, -2.4), 3.5);
    assertThat(SearchFact.Found.of(inexact, 7))
        .isEqualTo(new SearchFact.Found("object", 2, -2, 11));
  }

  private static SearchFact.Assigned assigned() {
    return new SearchFact.Assigned(3, new TreeMap<>(Map.of(BOT, "A", new RobotId("bot2"), "C")));
  }

  private static SearchFact.Leg leg(double x1, double y1, double x2, double y2) {
    return SearchFact.Leg.of(new Segment(new Point(x1, y1), new Point(x2, y2)));
  }

  @Test
  void valuesAreShortTexts() {
    assertThat(assigned()).hasToString("3 bot1=A bot2=C");
    assertThat(SearchFact.Assigned.NONE).hasToString("");
    assertThat(new SearchFact.Rooms(List.of("A", "C"))).hasToString("A C");
    assertThat(leg(500, 1_500, 899.6, 1_500)).hasToString("500,1500>900,1500");
    assertThat(leg(700, 700, 700, 700)).hasToString("700,700");
  }

  @Test
  void valuesAndFactsAreReadFromJson() throws JsonFormatException {
    assertRead(SearchFact.Assigned.SHAPE, assigned());
    assertRead(SearchFact.Assigned.SHAPE, SearchFact.Assigned.NONE);
    assertRead(SearchFact.Rooms.SHAPE, new SearchFact.Rooms(List.of("A", "C")));
    List<SearchFact> facts =
        List.of(
            new SearchFact.Swept("A"),
            new SearchFact.Planned("A", List.of(leg(1, 2, 3, 4), leg(5, 6, 5, 6))),
            new SearchFact.Found("object", 1, -2, 3),
            new SearchFact.Ended(Answer.NOTHING),
            new SearchFact.Ended(Answer.nothing(List.of("A", "B"))),
            new SearchFact.Ended(Answer.found("object", new Point(1, 2), BOT)));
    for (SearchFact fact : facts) {
      assertRead(SearchFact.SHAPE, fact);
    }
  }

  private static <T> void assertRead(Shape<T> shape, T value) throws JsonFormatException {
    String json = shape.json(value);
    assertThat(shape.readJson(new JsonReader("trace", 1, json))).as(json).isEqualTo(value);
  }
}
