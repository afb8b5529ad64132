package org.starl.sim.export;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionTask;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.Var;

class McapRecorderTest {

  private static final RobotId BOT = new RobotId("bot0");
  private static final Instance MUTEX = Instance.of("mutex", "m.1");

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();

  private String recorded(TraceEvent... events) throws IOException {
    try (McapRecorder recorder = new McapRecorder(out, Obstacles.NONE)) {
      recorder.started(new TraceHeader("0", "a", 7, 8, Map.of(), List.of(BOT)));
      List.of(events).forEach(recorder::observed);
    }
    return out.toString(StandardCharsets.ISO_8859_1);
  }

  private static <T> TraceEvent change(Instance source, String name, Shape<T> shape, T value) {
    return new TraceEvent.Variable(1, BOT, source, Var.of(name, shape), value);
  }

  @Test
  void eachVariableHasATopicAndItsValueIsJson() throws IOException {
    String file =
        recorded(
            change(Instance.APP, "rounds", Shapes.INT, 3),
            change(MUTEX, "crit", Shapes.BOOL, true),
            change(MotionFact.SOURCE, "(target, avoid)", MotionTask.SHAPE, new MotionTask.None()));
    assertThat(file)
        .contains("/variables/bot0/app/rounds", "\"name\":\"rounds\",\"value\":3}")
        .contains("/variables/bot0/mutex/m_1/crit", "\"source\":\"mutex/m.1\"")
        .contains("\"name\":\"crit\",\"value\":true}")
        .contains("/variables/bot0/motion/_target__avoid_", "\"value\":{\"None\":{}}}");
  }

  @Test
  void aMessageHasItsTextAndItsJson() throws IOException {
    Point point = new Point(1, 2);
    assertThat(recorded(new TraceEvent.Sent(1, BOT, "*", MUTEX, 1, 9, Geometry.POINT, point)))
        .contains("\"text\":\"" + point + "\",\"message\":{\"xMm\":1.0,\"yMm\":2.0}");
  }

  private static <T> JsonNode typeOf(Shape<T> shape, T value) throws IOException {
    ObjectMapper json = new ObjectMapper();
    String schema = McapSchemas.variable(json.readTree(shape.json(value)));
    return json.readTree(schema).at("/properties/value");
  }

  @Test
  void theSchemaOfAVariableHasTheTypeOfItsValues() throws IOException {
    assertThat(typeOf(Shapes.REAL, 1.5).at("/type").asText()).isEqualTo("number");
    assertThat(typeOf(Shapes.BOOL, false).at("/type").asText()).isEqualTo("boolean");
    assertThat(typeOf(Shapes.TEXT, "3").at("/type").asText()).isEqualTo("string");
    JsonNode point = typeOf(Geometry.POINT, new Point(1, 2));
    assertThat(point.at("/type").asText()).isEqualTo("object");
    assertThat(point.at("/properties/yMm/type").asText()).isEqualTo("number");
    JsonNode list = typeOf(Shapes.list(Geometry.POINT, 9), List.of(new Point(1, 2)));
    assertThat(list.at("/type").asText()).isEqualTo("array");
    assertThat(list.at("/items/properties/xMm/type").asText()).isEqualTo("number");
    assertThat(typeOf(Shapes.list(Shapes.INT, 9), List.of()).at("/items/type").asText())
        .isEqualTo("object");
    assertThat(typeOf(Shapes.optional(Shapes.INT), Optional.empty()).at("/type").asText())
        .isEqualTo("string");
  }
}
