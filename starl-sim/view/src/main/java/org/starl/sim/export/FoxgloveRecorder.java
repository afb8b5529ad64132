package org.starl.sim.export;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.util.RawValue;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.platform.LogSink.Level;
import org.starl.shape.Shape;
import org.starl.sim.Failure;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Scene;
import org.starl.sim.view.page.FloorShapes;
import org.starl.spec.Bodies;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/**
 * Shows a run as messages for Foxglove and similar robotics tools. Times are in ns from the start of
 * the run; lengths are in metres, as these tools expect. The latest message of each topic but {@code
 * /log} and {@code /messages} is enough to show a moment, so a tool may begin at any.
 *
 * <ul>
 *   <li>{@code /map}, {@code foxglove.SceneUpdate}: obstacles, once;
 *   <li>{@code /floor}, the same type: the app's drawing, such as zones, routes and goals, when it
 *       changes, every 500 ms at most;
 *   <li>{@code /trails}, the same type: where bodies have been, every second;
 *   <li>{@code /scene}, the same type: all true bodies every 50 ms while one moves;
 *   <li>{@code /tf}, {@code foxglove.FrameTransforms}: a frame for each body, named after its robot;
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
public final class FoxgloveRecorder implements SimObserver {

  private static final long STEP_NS = 50_000_000;

  /** In Foxglove's paths, other characters need quotes, or begin the name of a field. */
  private static final Pattern NOT_IN_TOPICS = Pattern.compile("[^A-Za-z0-9_/-]");

  private static final int STEPS_OF_FLOOR = 10;
  private static final int STEPS_OF_TRAILS = 20;

  private final MessageSink sink;
  private final Obstacles obstacles;
  private final Scene painted;
  private final Layer layer;
  private final ObjectMapper json = new ObjectMapper();
  private final FoxgloveScene scene = new FoxgloveScene(json);
  private final FloorShapes shapes = new FloorShapes();
  private final Bodies bodies = new Bodies();
  private final SortedMap<RobotId, Integer> poseChannels = new TreeMap<>();
  private final SortedMap<String, Integer> variableChannels = new TreeMap<>();
  private final Set<RobotId> moved = new TreeSet<>();
  private List<FloorShapes.Item> floor = List.of();
  private boolean hasBegun;
  private int sceneChannel;
  private int floorChannel;
  private int trailsChannel;
  private int transformsChannel;
  private int logChannel;
  private int messages;
  private long nextStepNs;
  private long lastNs;

  /**
   * @param obstacles of the world, hidden ones included
   * @param layer of the app; has observed no event, and is used by nothing else
   */
  public FoxgloveRecorder(Obstacles obstacles, Layer layer, MessageSink sink) {
    this.sink = sink;
    this.obstacles = obstacles;
    this.layer = layer;
    painted = new Scene(obstacles);
  }

  @Override
  public void started(TraceHeader header) {
    hasBegun = true;
    int map = sink.channel("/map", McapSchemas.SCENE);
    floorChannel = sink.channel("/floor", McapSchemas.SCENE);
    trailsChannel = sink.channel("/trails", McapSchemas.SCENE);
    sceneChannel = sink.channel("/scene", McapSchemas.SCENE);
    transformsChannel = sink.channel("/tf", McapSchemas.TRANSFORMS);
    logChannel = sink.channel("/log", McapSchemas.LOG);
    messages = sink.channel("/messages", McapSchemas.MESSAGE);
    ObjectNode update = scene.update();
    for (int i = 0; i < obstacles.all().size(); i++) {
      scene.addObstacle(update, "obstacle" + i, obstacles.all().get(i));
    }
    write(map, 0, update);
    log(0, Level.INFO, header.scenario(), "seed " + header.scenarioSeed());
  }

  @Override
  public void observed(TraceEvent event) {
    advance(event.timeNs());
    bodies.observe(event);
    painted.observe(event);
    layer.observe(event);
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
    alarm(violation.toString());
  }

  /** Tells of a violation now: it may have an earlier time, but times must not decrease. */
  public void alarm(String violation) {
    log(lastNs, Level.ERROR, "specification", violation);
  }

  /** As one message of {@code /failure}, with all fields, and as lines of the log. */
  @Override
  public void wentWrong(Failure failure) {
    int channel = sink.channel("/failure", McapSchemas.FAILURE);
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

  /** Writes what is due up to {@code timeNs}: no event before it follows. */
  public void advance(long timeNs) {
    while (nextStepNs <= timeNs) {
      step(nextStepNs);
      nextStepNs += STEP_NS;
    }
    lastNs = Math.max(lastNs, timeNs);
  }

  private void step(long timeNs) {
    List<RobotId> robots = List.copyOf(bodies.robots());
    boolean isNew = false;
    for (RobotId robot : robots) {
      if (bodies.isMoving(robot) || moved.contains(robot)) {
        isNew = true;
        write(poseChannel(robot), timeNs, scene.pose(timeNs, bodies, robot));
      }
    }
    moved.clear();
    long number = timeNs / STEP_NS;
    painted.advance(timeNs);
    if (isNew) {
      ObjectNode update = scene.update();
      robots.forEach(robot -> scene.addBody(update, timeNs, robot.name(), bodies, robot));
      write(sceneChannel, timeNs, update);
      write(transformsChannel, timeNs, scene.transforms(timeNs, bodies, robots));
    }
    if (isNew && layer.showsTrails() && number % STEPS_OF_TRAILS == 0) {
      ObjectNode update = scene.update();
      painted
          .robots()
          .forEach(robot -> scene.addTrail(update, timeNs, robot.name(), painted.trail(robot)));
      write(trailsChannel, timeNs, update);
    }
    if (number % STEPS_OF_FLOOR == 0) {
      List<FloorShapes.Item> now = shapes.of(painted, layer);
      if (!now.equals(floor)) {
        floor = now;
        ObjectNode update = scene.update();
        scene.addDrawing(update, timeNs, now);
        write(floorChannel, timeNs, update);
      }
    }
  }

  private int poseChannel(RobotId robot) {
    return poseChannels.computeIfAbsent(
        robot, id -> sink.channel("/pose/" + id.name(), McapSchemas.POSE));
  }

  /** A topic of its own for each variable: a tool that plots one need not read the others. */
  private int variableChannel(TraceEvent.Variable variable, String value) {
    String path =
        "/variables/" + variable.robot() + "/" + variable.source() + "/" + variable.name();
    return variableChannels.computeIfAbsent(
        NOT_IN_TOPICS.matcher(path).replaceAll("_"), topic -> sink.channel(topic, schemaOf(value)));
  }

  /** Of variables whose values are written like {@code value}. */
  private MessageSink.Schema schemaOf(String value) {
    try {
      return McapSchemas.variable(json.readTree(value));
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
    if (!hasBegun) {
      throw new IllegalStateException("an event before the start");
    }
    sink.message(channel, timeNs, message);
  }
}
