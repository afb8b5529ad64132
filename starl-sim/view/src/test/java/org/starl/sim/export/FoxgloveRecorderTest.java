package org.starl.sim.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionTask;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Scene;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.Var;

class FoxgloveRecorderTest {

  private static final RobotId BOT = new RobotId("bot0");
  private static final Instance MUTEX = Instance.of("mutex", "m.1");

  /** Keeps all messages, by topic. */
  private static final class Kept implements MessageSink {
    private final List<String> topics = new ArrayList<>();
    private final Map<String, List<JsonNode>> messages = new TreeMap<>();
    private long lastNs;

    @Override
    public int channel(String topic, Schema schema) {
      topics.add(topic);
      messages.put(topic, new ArrayList<>());
      return topics.size() - 1;
    }

    @Override
    public void message(int channel, long timeNs, ObjectNode message) {
      assertThat(timeNs).isGreaterThanOrEqualTo(lastNs);
      lastNs = timeNs;
      messages.get(topics.get(channel)).add(message.deepCopy());
    }

    private JsonNode last(String topic) {
      List<JsonNode> all = messages.get(topic);
      return all.get(all.size() - 1);
    }
  }

  /** Draws a filled zone, its outline and its name. */
  private static final Layer ZONE =
      new Layer() {
        @Override
        public Layer copy() {
          return this;
        }

        @Override
        public void paintFloor(Graphics2D floor, Scene scene, Look look) {
          floor.setColor(new Color(255, 0, 0, 51));
          floor.fill(new Rectangle2D.Double(1000, 2000, 500, 700));
          floor.setStroke(new BasicStroke(20));
          floor.draw(new Line2D.Double(0, 0, 3000, 0));
          Graphics2D upright = (Graphics2D) floor.create();
          upright.scale(1, -1);
          upright.drawString("zone A", 100, -200);
        }
      };

  private final Kept kept = new Kept();

  private String recorded(TraceEvent... events) {
    FoxgloveRecorder recorder = new FoxgloveRecorder(Obstacles.NONE, ZONE, kept);
    recorder.started(new TraceHeader("0", "a", 7, 8, Map.of(), List.of(BOT)));
    List.of(events).forEach(recorder::observed);
    recorder.advance(2_000_000_000);
    return kept.messages.toString();
  }

  @Test
  void theLatestMessageOfEachTopicShowsAMoment() {
    RobotId other = new RobotId("bot1");
    recorded(
        new TraceEvent.Joined(0, BOT, new Pose(0, 0, 0), 150),
        new TraceEvent.Joined(0, other, new Pose(900, 0, 0), 150),
        new TraceEvent.Moved(1, BOT, new Pose(0, 0, 0), 100, 0));
    JsonNode scene = kept.last("/scene");
    assertThat(scene.findValuesAsText("id")).containsExactly("bot0", "bot1");
    assertThat(scene.at("/entities/0/cylinders/0/pose/position/x").asDouble())
        .isCloseTo(0.2, within(0.01));
    JsonNode transforms = kept.last("/tf").get("transforms");
    assertThat(transforms.findValuesAsText("child_frame_id")).containsExactly("bot0", "bot1");
    assertThat(transforms.get(1).at("/translation/x").asDouble()).isEqualTo(0.9);
    JsonNode trails = kept.last("/trails");
    assertThat(trails.at("/entities/0/lines/0/points").size()).isGreaterThan(5);
  }

  @Test
  void theFloorHasWhatTheAppDrawsInMetres() {
    recorded();
    assertThat(kept.messages.get("/floor")).hasSize(1); // it does not change
    JsonNode drawn = kept.last("/floor").at("/entities/0");
    JsonNode zone = drawn.at("/triangles/0");
    assertThat(zone.get("points")).hasSize(6);
    assertThat(zone.at("/points/0").toString()).isEqualTo("{\"x\":1.0,\"y\":2.0,\"z\":0.0}");
    assertThat(zone.at("/color/a").asDouble()).isEqualTo(0.2);
    JsonNode line = drawn.at("/lines/0");
    assertThat(line.get("thickness").asDouble()).isEqualTo(0.02);
    assertThat(line.at("/points/1/x").asDouble()).isEqualTo(3.0);
    JsonNode name = drawn.at("/texts/0");
    assertThat(name.get("text").asText()).isEqualTo("zone A");
    assertThat(name.at("/pose/position/y").asDouble()).isEqualTo(0.2);
  }

  private static <T> TraceEvent change(Instance source, String name, Shape<T> shape, T value) {
    return new TraceEvent.Variable(1, BOT, source, Var.of(name, shape), value);
  }

  @Test
  void eachVariableHasATopicAndItsValueIsJson() {
    String file =
        recorded(
            change(Instance.APP, "rounds", Shapes.INT, 3),
            change(MUTEX, "crit", Shapes.BOOL, true),
            change(MotionFact.SOURCE, "(target, avoid)", MotionTask.SHAPE, new MotionTask.None()));
    assertThat(file)
        .contains("/variables/bot0/app/rounds=[", "\"name\":\"rounds\",\"value\":3}")
        .contains("/variables/bot0/mutex/m_1/crit", "\"source\":\"mutex/m.1\"")
        .contains("\"name\":\"crit\",\"value\":true}")
        .contains("/variables/bot0/motion/_target__avoid_", "\"value\":{\"None\":{}}}");
  }

  @Test
  void aMessageHasItsTextAndItsJson() {
    Point point = new Point(1, 2);
    assertThat(recorded(new TraceEvent.Sent(1, BOT, "*", MUTEX, 1, 9, Geometry.POINT, point)))
        .contains("\"text\":\"" + point + "\",\"message\":{\"xMm\":1.0,\"yMm\":2.0}");
  }

  private static <T> JsonNode typeOf(Shape<T> shape, T value) throws IOException {
    ObjectMapper json = new ObjectMapper();
    String schema = McapSchemas.variable(json.readTree(shape.json(value))).json();
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
