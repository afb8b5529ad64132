package org.starl.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Decimals;
import org.starl.shape.JsonFormatException;
import org.starl.shape.JsonReader;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;

/**
 * The inverse of {@link TraceCodec}. Reads components in the order of their records, which is their
 * order in the line. Events share the ids of robots and instances.
 */
final class EventParser {

  private final Vocabulary vocabulary;
  private final Map<String, RobotId> robots = new HashMap<>();
  private final Map<String, Instance> instances = new HashMap<>();
  private final Map<String, Var<?>> variables = new HashMap<>();
  private final Map<String, RecordShape<?>> unknown = new HashMap<>();

  EventParser(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
  }

  TraceHeader header(JsonReader line) throws JsonFormatException {
    if (!line.take("{\"kind\":\"header\",\"format\":")) {
      throw line.expected("the header of a StarL trace");
    }
    if (!line.take(TraceHeader.FORMAT + ",")) {
      throw line.expected("format " + TraceHeader.FORMAT);
    }
    String starl = line.text("\"starl\":");
    String scenario = line.text(",\"scenario\":");
    long scenarioSeed = line.number(",\"scenarioSeed\":");
    long behaviourSeed = line.number(",\"behaviourSeed\":");
    Map<String, String> settings = line.stringMap(",\"settings\":");
    line.expect(",\"robots\":[");
    List<RobotId> deployment = robots(line);
    line.expectEndOfObject();
    return new TraceHeader(starl, scenario, scenarioSeed, behaviourSeed, settings, deployment);
  }

  /** Reads the rest of the last line, after its time. */
  TraceEnd traceEnd(JsonReader line, long timeNs, long events) throws JsonFormatException {
    line.expect(",\"events\":");
    List<RobotId> unfinished = List.of();
    if (line.take(events + ",\"unfinished\":[")) {
      unfinished = robots(line);
      line.expectEndOfObject();
    } else if (line.take(events + "}")) {
      line.expectEnd();
    } else {
      throw line.expected(events + "}, the number of events above");
    }
    return new TraceEnd(timeNs, events, unfinished);
  }

  /** Reads the rest of a list. */
  private List<RobotId> robots(JsonReader line) throws JsonFormatException {
    List<RobotId> robots = new ArrayList<>();
    if (!line.take("]")) {
      do {
        robots.add(robot(line, ""));
      } while (line.take(","));
      line.expect("]");
    }
    return robots;
  }

  /** Reads the rest of an event's line, after its time. */
  TraceEvent event(JsonReader line, String kind, long timeNs) throws JsonFormatException {
    RobotId robot = robot(line, ",\"robot\":");
    TraceEvent event =
        switch (kind) {
          case "action" -> action(line, timeNs, robot);
          case "variable" -> variable(line, timeNs, robot);
          case "sent" -> {
            String to = line.text(",\"to\":");
            Instance channel = instance(line, ",\"channel\":");
            Shape<?> shape = vocabulary.message(channel);
            yield new TraceEvent.Sent(
                timeNs,
                robot,
                to,
                channel,
                line.number(",\"seq\":"),
                line.smallNumber(",\"bytes\":"),
                shape,
                value(line, ",\"message\":", shape));
          }
          case "delivered" -> {
            RobotId from = robot(line, ",\"from\":");
            Instance channel = instance(line, ",\"channel\":");
            Shape<?> shape = vocabulary.message(channel);
            yield new TraceEvent.Delivered(
                timeNs,
                robot,
                from,
                channel,
                line.number(",\"seq\":"),
                shape,
                value(line, ",\"message\":", shape));
          }
          case "dropped" ->
              new TraceEvent.Dropped(
                  timeNs, robot, line.text(",\"from\":"), line.text(",\"why\":"));
          case "moved" ->
              new TraceEvent.Moved(
                  timeNs,
                  robot,
                  pose(line),
                  line.decimal(",\"linearMmPerS\":", Decimals.MM),
                  line.decimal(",\"angularRadPerS\":", Decimals.RAD));
          case "joined" ->
              new TraceEvent.Joined(
                  timeNs, robot, pose(line), line.decimal(",\"radiusMm\":", Decimals.MM));
          case "left" -> new TraceEvent.Left(timeNs, robot);
          case "fault" ->
              new TraceEvent.Fault(
                  timeNs,
                  robot,
                  line.text(",\"name\":"),
                  line.text(",\"effect\":"),
                  line.text(",\"detail\":"));
          case "intervention" ->
              new TraceEvent.Intervention(
                  timeNs,
                  robot,
                  line.number(",\"step\":"),
                  line.text(",\"name\":"),
                  line.text(",\"detail\":"));
          default -> throw line.unknown("kind", kind);
        };
    line.expectEndOfObject();
    return event;
  }

  private TraceEvent action(JsonReader line, long timeNs, RobotId robot)
      throws JsonFormatException {
    Instance source = instance(line, ",\"source\":");
    String name = line.text(",\"fact\":{");
    RecordShape<?> known = vocabulary.fact(source, name);
    RecordShape<?> shape = known == null ? unknown(name) : known;
    Object fact = value(line, ":", shape);
    line.expect("}");
    return new TraceEvent.Action(timeNs, robot, source, shape, fact);
  }

  private TraceEvent variable(JsonReader line, long timeNs, RobotId robot)
      throws JsonFormatException {
    Instance source = instance(line, ",\"source\":");
    String name = line.text(",\"name\":");
    Var<?> variable =
        variables.computeIfAbsent(
            source.primitive() + " " + name, key -> vocabulary.variable(source, name));
    return new TraceEvent.Variable(
        timeNs, robot, source, variable, value(line, ",\"value\":", variable.shape()));
  }

  private RecordShape<?> unknown(String name) {
    return unknown.computeIfAbsent(name, RecordShape::unknown);
  }

  private static Object value(JsonReader line, String key, Shape<?> shape)
      throws JsonFormatException {
    line.expect(key);
    return shape.readJson(line);
  }

  private Instance instance(JsonReader line, String key) throws JsonFormatException {
    return instances.computeIfAbsent(line.text(key), Instance::named);
  }

  private static Pose pose(JsonReader line) throws JsonFormatException {
    return new Pose(
        line.decimal(",\"xMm\":", Decimals.MM),
        line.decimal(",\"yMm\":", Decimals.MM),
        line.decimal(",\"headingRad\":", Decimals.RAD));
  }

  private RobotId robot(JsonReader line, String key) throws JsonFormatException {
    return robots.computeIfAbsent(line.robotName(key), RobotId::new);
  }
}
