package org.starl.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/** The inverse of {@link TraceCodec}. Robots of one trace share their ids. */
final class EventParser {

  private final Map<String, RobotId> robots = new HashMap<>();

  TraceHeader header(LineParser line) throws TraceFormatException {
    if (!line.take("{\"kind\":\"header\",\"format\":")) {
      throw line.expected("the header of a StarL trace");
    }
    if (!line.take(TraceHeader.FORMAT + ",")) {
      throw line.expected("format " + TraceHeader.FORMAT);
    }
    String starl = text(line, "\"starl\":");
    String scenario = text(line, ",\"scenario\":");
    long scenarioSeed = number(line, ",\"scenarioSeed\":");
    long behaviourSeed = number(line, ",\"behaviourSeed\":");
    line.expect(",\"settings\":");
    Map<String, String> settings = line.stringMap();
    List<RobotId> deployment = new ArrayList<>();
    line.expect(",\"robots\":[");
    if (!line.take("]")) {
      do {
        deployment.add(robot(line, ""));
      } while (line.take(","));
      line.expect("]");
    }
    end(line);
    return new TraceHeader(starl, scenario, scenarioSeed, behaviourSeed, settings, deployment);
  }

  /** The rest of the line of kind end, after its time. */
  TraceEnd traceEnd(LineParser line, long timeNs, long events) throws TraceFormatException {
    line.expect(",\"events\":");
    if (!line.take(events + "}")) {
      throw line.expected(events + "}, the number of events above");
    }
    line.expectEnd();
    return new TraceEnd(timeNs, events);
  }

  /** The rest of the line of an event, after its time. */
  TraceEvent event(LineParser line, String kind, long timeNs) throws TraceFormatException {
    RobotId robot = robot(line, ",\"robot\":");
    TraceEvent event =
        switch (kind) {
          case "action" -> action(line, timeNs, robot);
          case "variable" -> variable(line, timeNs, robot);
          case "sent" -> sent(line, timeNs, robot);
          case "delivered" -> delivered(line, timeNs, robot);
          case "dropped" -> dropped(line, timeNs, robot);
          case "moved" -> moved(line, timeNs, robot);
          case "joined" -> joined(line, timeNs, robot);
          case "left" -> new TraceEvent.Left(timeNs, robot);
          case "fault" -> fault(line, timeNs, robot);
          case "intervention" -> intervention(line, timeNs, robot);
          default -> throw line.unknown("kind", kind);
        };
    end(line);
    return event;
  }

  private static TraceEvent action(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    String source = text(line, ",\"source\":");
    String name = text(line, ",\"name\":");
    line.expect(",\"args\":");
    return new TraceEvent.Action(timeNs, robot, source, name, line.strings());
  }

  private static TraceEvent variable(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    String source = text(line, ",\"source\":");
    String name = text(line, ",\"name\":");
    String value = text(line, ",\"value\":");
    return new TraceEvent.Variable(timeNs, robot, source, name, value);
  }

  private static TraceEvent sent(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    String to = text(line, ",\"to\":");
    String channel = text(line, ",\"channel\":");
    long seq = number(line, ",\"seq\":");
    line.expect(",\"bytes\":");
    int bytes = line.smallNumber();
    String message = text(line, ",\"message\":");
    return new TraceEvent.Sent(timeNs, robot, to, channel, seq, bytes, message);
  }

  private TraceEvent delivered(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    RobotId from = robot(line, ",\"from\":");
    String channel = text(line, ",\"channel\":");
    long seq = number(line, ",\"seq\":");
    String message = text(line, ",\"message\":");
    return new TraceEvent.Delivered(timeNs, robot, from, channel, seq, message);
  }

  private static TraceEvent dropped(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    String from = text(line, ",\"from\":");
    String why = text(line, ",\"why\":");
    return new TraceEvent.Dropped(timeNs, robot, from, why);
  }

  private static TraceEvent moved(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    Pose pose = pose(line);
    double linearMmPerS = decimal(line, ",\"linearMmPerS\":", Decimals.MM);
    double angularRadPerS = decimal(line, ",\"angularRadPerS\":", Decimals.RAD);
    return new TraceEvent.Moved(timeNs, robot, pose, linearMmPerS, angularRadPerS);
  }

  private static TraceEvent joined(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    Pose pose = pose(line);
    double radiusMm = decimal(line, ",\"radiusMm\":", Decimals.MM);
    return new TraceEvent.Joined(timeNs, robot, pose, radiusMm);
  }

  private static TraceEvent fault(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    String name = text(line, ",\"name\":");
    return new TraceEvent.Fault(timeNs, robot, name, text(line, ",\"detail\":"));
  }

  private static TraceEvent intervention(LineParser line, long timeNs, RobotId robot)
      throws TraceFormatException {
    long step = number(line, ",\"step\":");
    String name = text(line, ",\"name\":");
    return new TraceEvent.Intervention(timeNs, robot, step, name, text(line, ",\"detail\":"));
  }

  private static Pose pose(LineParser line) throws TraceFormatException {
    double xMm = decimal(line, ",\"xMm\":", Decimals.MM);
    double yMm = decimal(line, ",\"yMm\":", Decimals.MM);
    return new Pose(xMm, yMm, decimal(line, ",\"headingRad\":", Decimals.RAD));
  }

  private RobotId robot(LineParser line, String key) throws TraceFormatException {
    line.expect(key);
    return robots.computeIfAbsent(line.robotName(), RobotId::new);
  }

  private static String text(LineParser line, String key) throws TraceFormatException {
    line.expect(key);
    return line.string();
  }

  private static long number(LineParser line, String key) throws TraceFormatException {
    line.expect(key);
    return line.number();
  }

  private static double decimal(LineParser line, String key, int decimals)
      throws TraceFormatException {
    line.expect(key);
    return line.decimal(decimals);
  }

  private static void end(LineParser line) throws TraceFormatException {
    line.expect("}");
    line.expectEnd();
  }
}
