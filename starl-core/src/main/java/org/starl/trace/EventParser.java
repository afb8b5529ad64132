package org.starl.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * The inverse of {@link TraceCodec}. Reads components in the order of their records, which is their
 * order in the line. Events of one robot share its id.
 */
final class EventParser {

  private final Map<String, RobotId> robots = new HashMap<>();

  TraceHeader header(LineParser line) throws TraceFormatException {
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
    List<RobotId> deployment = new ArrayList<>();
    line.expect(",\"robots\":[");
    if (!line.take("]")) {
      do {
        deployment.add(robot(line, ""));
      } while (line.take(","));
      line.expect("]");
    }
    line.expectEndOfObject();
    return new TraceHeader(starl, scenario, scenarioSeed, behaviourSeed, settings, deployment);
  }

  /** Reads the rest of the last line, after its time. */
  TraceEnd traceEnd(LineParser line, long timeNs, long events) throws TraceFormatException {
    line.expect(",\"events\":");
    if (!line.take(events + "}")) {
      throw line.expected(events + "}, the number of events above");
    }
    line.expectEnd();
    return new TraceEnd(timeNs, events);
  }

  /** Reads the rest of an event's line, after its time. */
  TraceEvent event(LineParser line, String kind, long timeNs) throws TraceFormatException {
    RobotId robot = robot(line, ",\"robot\":");
    TraceEvent event =
        switch (kind) {
          case "action" ->
              new TraceEvent.Action(
                  timeNs,
                  robot,
                  line.text(",\"source\":"),
                  line.text(",\"name\":"),
                  line.texts(",\"args\":"));
          case "variable" ->
              new TraceEvent.Variable(
                  timeNs,
                  robot,
                  line.text(",\"source\":"),
                  line.text(",\"name\":"),
                  line.text(",\"value\":"));
          case "sent" ->
              new TraceEvent.Sent(
                  timeNs,
                  robot,
                  line.text(",\"to\":"),
                  line.text(",\"channel\":"),
                  line.number(",\"seq\":"),
                  line.smallNumber(",\"bytes\":"),
                  line.text(",\"message\":"));
          case "delivered" ->
              new TraceEvent.Delivered(
                  timeNs,
                  robot,
                  robot(line, ",\"from\":"),
                  line.text(",\"channel\":"),
                  line.number(",\"seq\":"),
                  line.text(",\"message\":"));
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
                  timeNs, robot, line.text(",\"name\":"), line.text(",\"detail\":"));
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

  private static Pose pose(LineParser line) throws TraceFormatException {
    return new Pose(
        line.decimal(",\"xMm\":", Decimals.MM),
        line.decimal(",\"yMm\":", Decimals.MM),
        line.decimal(",\"headingRad\":", Decimals.RAD));
  }

  private RobotId robot(LineParser line, String key) throws TraceFormatException {
    return robots.computeIfAbsent(line.robotName(key), RobotId::new);
  }
}
