package org.starl.sim.export;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;
import org.starl.shape.Shape;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.spec.Bodies;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Writes a run as an MCAP file, for Foxglove and similar robotics tools. Times are in ns from the
 * start of the run; lengths are in metres, as these tools expect.
 *
 * <ul>
 *   <li>{@code /scene}, {@code foxglove.SceneUpdate}: obstacles once, and true bodies every 50 ms
 *       while they move;
 *   <li>{@code /pose/ROBOT}, {@code foxglove.PoseInFrame}, every 50 ms while the robot moves;
 *   <li>{@code /log}, {@code foxglove.Log}: actions, faults, log lines of robots, and violations of
 *       specifications;
 *   <li>{@code /variables/ROBOT/SOURCE/NAME}, {@code starl.Variable}: each change of a variable,
 *       with its value as JSON, so that numbers can be plotted;
 *   <li>{@code /messages}, {@code starl.Message}: each datagram sent, delivered or dropped, with its
 *       message as text and as JSON;
 *   <li>{@code /failure}, {@code starl.Failure}, in a bad run: one message that describes what went
 *       wrong, with poses in mm and rad.
 * </ul>
 */
public final class McapRecorder implements SimObserver, Closeable {

  private static final long STEP_NS = 50_000_000;

  /** In Foxglove's paths, other characters need quotes, or begin the name of a field. */
  private static final Pattern NOT_IN_TOPICS = Pattern.compile("[^A-Za-z0-9_/-]");

  private final OutputStream out;
  private final Obstacles obstacles;
  private final ObjectMapper json = new ObjectMapper();
  private final FoxgloveScene scene = new FoxgloveScene(json);
  private final Bodies bodies = new Bodies();
  private final SortedMap<RobotId, Integer> poseChannels = new TreeMap<>();
  private final SortedMap<String, Integer> variableChannels = new TreeMap<>();
  private final SortedMap<String, Integer> variableSchemas = new TreeMap<>();
  private final Set<RobotId> moved = new TreeSet<>();
  private @Nullable McapWriter writer;
  private int sceneChannel;
  private int logChannel;
  private int messages;
  private int poseSchema;
  private long nextStepNs;
  private long lastNs;

  /**
   * @param out closed by {@link #close}
   * @param obstacles of the world, hidden ones included
   */
  public McapRecorder(OutputStream out, Obstacles obstacles) {
    this.out = out;
    this.obstacles = obstacles;
  }

  @Override
  public void started(TraceHeader header) {
    try {
      McapWriter begun = new McapWriter(out, "StarL " + header.starl());
      writer = begun;
      sceneChannel =
          begun.channel(begun.schema("foxglove.SceneUpdate", McapSchemas.SCENE), "/scene");
      logChannel = begun.channel(begun.schema("foxglove.Log", McapSchemas.LOG), "/log");
      messages = begun.channel(begun.schema("starl.Message", McapSchemas.MESSAGE), "/messages");
      poseSchema = begun.schema("foxglove.PoseInFrame", McapSchemas.POSE);
    } catch (IOException e) {
      throw unwritable(e);
    }
    ObjectNode update = scene.update();
    for (int i = 0; i < obstacles.all().size(); i++) {
      scene.addObstacle(update, "obstacle" + i, obstacles.all().get(i));
    }
    write(sceneChannel, 0, update);
    log(0, Level.INFO, header.scenario(), "seed " + header.scenarioSeed());
  }

  @Override
  public void observed(TraceEvent event) {
    advance(event.timeNs());
    bodies.observe(event);
    long timeNs = event.timeNs();
    String robot = event.robot().name();
    switch (event) {
      case TraceEvent.Action action ->
          log(timeNs, Level.INFO, robot, action.source() + " " + action.name() + action.args());
      case TraceEvent.Variable variable -> {
        String value = jsonOf(variable.variable().shape(), variable.value());
        write(
            variableChannel(variable, value),
            timeNs,
            json.createObjectNode()
                .put("robot", robot)
                .put("source", variable.source().name())
                .put("name", variable.name())
                .putRawValue("value", new RawValue(value)));
      }
      case TraceEvent.Sent sent ->
          write(
              messages,
              timeNs,
              withContent(
                  message("sent", robot, sent.to(), sent.channel().name(), sent.seq())
                      .put("bytes", sent.bytes()),
                  sent.shape(),
                  sent.message()));
      case TraceEvent.Delivered delivered ->
          write(
              messages,
              timeNs,
              withContent(
                  message(
                      "delivered",
                      delivered.from().name(),
                      robot,
                      delivered.channel().name(),
                      delivered.seq()),
                  delivered.shape(),
                  delivered.message()));
      case TraceEvent.Dropped dropped ->
          write(
              messages,
              timeNs,
              message("dropped", dropped.from(), robot, "", 0).put("why", dropped.why()));
      case TraceEvent.Joined joined -> moved.add(joined.robot());
      case TraceEvent.Moved motion -> moved.add(motion.robot());
      case TraceEvent.Left left -> {
        moved.remove(left.robot());
        write(sceneChannel, timeNs, scene.deletion(timeNs, robot));
      }
      case TraceEvent.Fault fault ->
          log(timeNs, Level.WARN, robot, fault.name() + " " + fault.detail());
      case TraceEvent.Intervention intervention -> {
        String what = intervention.name() + " " + intervention.detail();
        log(timeNs, Level.WARN, robot, "intervention: " + what);
      }
    }
  }

  @Override
  public void violated(SpecReport.Violation violation) {
    // A violation may have an earlier time, but times in the file must not decrease.
    log(lastNs, Level.ERROR, "specification", violation.toString());
  }

  /** As one message of {@code /failure}, with all fields, and as lines of the log. */
  @Override
  public void wentWrong(Failure failure) {
    int channel = begun().channel(begun().schema("starl.Failure", McapSchemas.FAILURE), "/failure");
    write(channel, lastNs, json.valueToTree(failure.fields()));
    failure.lines().forEach(line -> log(lastNs, Level.ERROR, "failure", line));
  }

  @Override
  public void logged(long timeNs, RobotId robot, Level level, String tag, String line) {
    advance(timeNs);
    log(timeNs, level, robot.name(), tag + ": " + line);
  }

  @Override
  public void finished(SimResult result) {
    advance(result.endNs());
  }

  /**
   * Writes buffered data and the summary.
   *
   * @throws IOException if the data cannot be written
   */
  @Override
  public void close() throws IOException {
    if (writer == null) {
      out.close();
    } else {
      writer.close();
    }
  }

  /** Writes the bodies' poses at each step up to {@code timeNs}. */
  private void advance(long timeNs) {
    while (nextStepNs <= timeNs) {
      ObjectNode update = null;
      for (RobotId robot : List.copyOf(bodies.robots())) {
        if (bodies.isMoving(robot) || moved.contains(robot)) {
          update = update == null ? scene.update() : update;
          scene.addBody(update, nextStepNs, robot.name(), bodies, robot);
          write(poseChannel(robot), nextStepNs, scene.pose(nextStepNs, bodies, robot));
        }
      }
      moved.clear();
      if (update != null) {
        write(sceneChannel, nextStepNs, update);
      }
      nextStepNs += STEP_NS;
    }
    lastNs = timeNs;
  }

  private int poseChannel(RobotId robot) {
    return poseChannels.computeIfAbsent(
        robot, id -> begun().channel(poseSchema, "/pose/" + id.name()));
  }

  /** A topic of its own for each variable: a tool that plots one need not read the others. */
  private int variableChannel(TraceEvent.Variable variable, String value) {
    String path =
        "/variables/" + variable.robot() + "/" + variable.source() + "/" + variable.name();
    return variableChannels.computeIfAbsent(
        NOT_IN_TOPICS.matcher(path).replaceAll("_"),
        topic -> begun().channel(variableSchema(value), topic));
  }

  /** Of variables whose values are written like {@code value}. */
  private int variableSchema(String value) {
    try {
      return variableSchemas.computeIfAbsent(
          McapSchemas.variable(json.readTree(value)),
          schema -> begun().schema("starl.Variable", schema));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @SuppressWarnings("unchecked") // an event has values of its shapes only
  private static <T> String jsonOf(Shape<T> shape, Object value) {
    return shape.json((T) value);
  }

  private ObjectNode message(String fate, String from, String to, String channel, long seq) {
    return json.createObjectNode()
        .put("fate", fate)
        .put("from", from)
        .put("to", to)
        .put("channel", channel)
        .put("seq", seq);
  }

  /** As text, and as JSON if it is an object: what is a string in JSON is that text. */
  private static ObjectNode withContent(ObjectNode node, Shape<?> shape, Object message) {
    node.put("text", message.toString());
    String value = jsonOf(shape, message);
    return value.startsWith("{") ? node.putRawValue("message", new RawValue(value)) : node;
  }

  private void log(long timeNs, Level level, String name, String text) {
    write(logChannel, timeNs, scene.log(timeNs, level, name, text));
  }

  private void write(int channel, long timeNs, ObjectNode message) {
    try {
      begun().message(channel, timeNs, json.writeValueAsBytes(message));
    } catch (IOException e) {
      throw unwritable(e);
    }
  }

  private McapWriter begun() {
    if (writer == null) {
      throw new IllegalStateException("an event before the start");
    }
    return writer;
  }

  private static UncheckedIOException unwritable(IOException e) {
    return new UncheckedIOException("the MCAP file cannot be written", e);
  }
}
