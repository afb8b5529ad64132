package org.starl.trace;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.comms.Codec;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.shape.Geometry;
import org.starl.shape.Json;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

class VocabularyTest {

  private static final RobotId BOT = new RobotId("bot0");
  private static final Instance TALK = Instance.of("talk", "1");
  private static final Shape<Point> POINT = Geometry.POINT;
  private static final Shape<Point> BYTES = Codec.of(POINT::write, POINT::read);

  private record Said(int number) {
    static final RecordShape<Said> SHAPE =
        Shapes.of(Said.class, Shapes.part("number", Shapes.INT, Said::number), Said::new);
  }

  private record Asked(String text) {
    static final RecordShape<Asked> SHAPE =
        Shapes.of(Asked.class, Shapes.part("text", Shapes.TEXT, Asked::text), Asked::new)
            .named("Said");
  }

  private static TraceEvent sent(Instance channel, Shape<Point> shape) {
    return new TraceEvent.Sent(1, BOT, "*", channel, 1, 9, shape, new Point(1, 2));
  }

  private static TraceEvent variable(Var<Point> variable) {
    return new TraceEvent.Variable(1, BOT, TALK, variable, new Point(1, 2));
  }

  private static <F> TraceEvent action(RecordShape<F> shape, F fact) {
    return TraceEvent.Action.of(1, BOT, TALK, shape, fact);
  }

  private static Object read(Shape<?> shape, String json) throws JsonFormatException {
    return shape.readJson(new JsonReader("a.trace", 1, json));
  }

  @Test
  void theNameOfAChannelGoesBeforeItsKind() {
    Vocabulary vocabulary = Vocabulary.NONE.messages("talk", POINT).messages(TALK, Shapes.TEXT);
    assertThat(vocabulary.message(TALK)).isSameAs(Shapes.TEXT);
    assertThat(vocabulary.message(Instance.of("talk", "2"))).isSameAs(POINT);
  }

  @Test
  void twoVocabulariesAreOne() {
    Var<Point> at = Var.of("at", POINT);
    Vocabulary both =
        Vocabulary.NONE.facts("talk", Said.SHAPE).and(Vocabulary.NONE.variables("talk", at));
    assertThat(both.fact(TALK, "Said")).isSameAs(Said.SHAPE);
    assertThat(both.fact(Instance.of("mutex", "1"), "Said")).isNull();
    assertThat(both.variable(TALK, "at")).isSameAs(at);
  }

  @Test
  void theShapesOfEventsAreLearned() {
    Var<Point> at = Var.of("at", POINT);
    Vocabulary vocabulary =
        Vocabulary.NONE
            .with(sent(TALK, POINT))
            .with(variable(at))
            .with(action(Said.SHAPE, new Said(1)))
            .with(new TraceEvent.Left(1, BOT));
    assertThat(vocabulary.message(TALK)).isSameAs(POINT);
    assertThat(vocabulary.variable(TALK, "at")).isSameAs(at);
    assertThat(vocabulary.fact(TALK, "Said")).isSameAs(Said.SHAPE);
    assertThat(vocabulary.with(variable(at)).with(sent(TALK, POINT))).isSameAs(vocabulary);
  }

  @Test
  void whatHasOneNameAndTwoTypesIsReadAsJson() throws JsonFormatException {
    Vocabulary vocabulary =
        Vocabulary.NONE
            .with(action(Said.SHAPE, new Said(1)))
            .with(action(Asked.SHAPE, new Asked("x")))
            .with(variable(Var.of("at", POINT)))
            .with(variable(Var.of("at", BYTES)));
    RecordShape<?> fact = vocabulary.fact(TALK, "Said");
    assertThat(fact).isNotNull();
    assertThat(read(fact, "{\"number\":1}")).isEqualTo(new Json("{\"number\":1}"));
    assertThat(read(vocabulary.variable(TALK, "at").shape(), "{\"xMm\":1.0}"))
        .isEqualTo(new Json("{\"xMm\":1.0}"));
    assertThat(vocabulary.with(action(Said.SHAPE, new Said(2)))).isSameAs(vocabulary);
  }

  @Test
  void aShapeThatCannotReadIsReadAsItsText() throws JsonFormatException {
    Vocabulary vocabulary = Vocabulary.NONE.with(sent(TALK, BYTES));
    Point point = new Point(1, 2);
    Object text = read(vocabulary.message(TALK), BYTES.json(point));
    assertThat(text).isEqualTo(point.toString());
  }

  @Test
  void anUnknownStringIsItsTextAndIsWrittenAsItWas() throws JsonFormatException {
    @SuppressWarnings("unchecked") // it reads and writes any value
    Shape<Object> shape = (Shape<Object>) Vocabulary.NONE.message(TALK);
    for (String json : new String[] {"\"a\\\"b\"", "{\"a\":[1]}", "null", "1.50"}) {
      assertThat(shape.json(read(shape, json))).isEqualTo(json);
    }
    assertThat(read(shape, "\"a\\\"b\"")).isEqualTo("a\"b");
  }
}
