package org.starl.sim.view;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.Scene;
import org.starl.sim.replay.LogLine;
import org.starl.sim.replay.Recording;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;

/** The state of one robot at a moment of a recording; computed on demand. */
final class Inspection {

  private static final int MOST_LINES = 60;
  private static final int MOST_EVENTS = 60_000;
  private static final double NS_PER_S = 1e9;

  private Inspection() {}

  /**
   * A row of a table.
   *
   * @param isTitle whether the row is the title of a group; its value is then empty
   */
  record Row(boolean isTitle, String name, String value) {}

  /**
   * A line about one event.
   *
   * @param more the full text
   */
  record Line(long timeNs, String what, String text, String more) {}

  /** Its body, then the variables of its app, of motion and of each primitive. */
  static List<Row> state(Scene scene, RobotId robot) {
    List<Row> rows = new ArrayList<>();
    rows.add(new Row(true, "body", ""));
    Optional<Pose> pose = scene.pose(robot);
    if (pose.isPresent()) {
      rows.add(new Row(false, "position", mm(pose.get().xMm()) + ", " + mm(pose.get().yMm())));
      double degrees = StrictMath.toDegrees(pose.get().headingRad());
      rows.add(new Row(false, "heading", String.format(Locale.ROOT, "%.0f\u00b0", degrees)));
    } else {
      rows.add(new Row(false, "position", "not on the floor"));
    }
    rows.add(new Row(false, "program", scene.isDown(robot) ? "crashed" : "runs"));
    String source = "";
    List<Scene.Value> values = new ArrayList<>(scene.variables(robot));
    values.sort(Comparator.comparingInt(Inspection::rank));
    for (Scene.Value value : values) {
      if (!value.source().equals(source)) {
        source = value.source();
        rows.add(new Row(true, source, ""));
      }
      rows.add(new Row(false, value.name(), value.value()));
    }
    return rows;
  }

  /** The app comes first, then motion, then each primitive. */
  private static int rank(Scene.Value value) {
    return value.source().equals("app") ? 0 : value.source().equals("motion") ? 1 : 2;
  }

  private static String mm(double mm) {
    return String.format(Locale.ROOT, "%.0f mm", mm);
  }

  /** The robot's recent messages, latest first. */
  static List<Line> messages(Recording recording, int index, RobotId robot) {
    List<Line> lines = new ArrayList<>();
    int least = Math.max(0, index - MOST_EVENTS);
    for (int i = index - 1; i >= least && lines.size() < MOST_LINES; i--) {
      TraceEvent event = recording.event(i);
      if (event.robot().equals(robot)) {
        switch (event) {
          case Sent out -> {
            String to = out.to().equals("*") ? "all" : out.to();
            lines.add(message(out.timeNs(), "\u2192 " + to, out.channel(), out.message()));
          }
          case Delivered in ->
              lines.add(message(in.timeNs(), "\u2190 " + in.from(), in.channel(), in.message()));
          case Dropped lost ->
              lines.add(new Line(lost.timeNs(), "\u2715 " + lost.from(), lost.why(), lost.why()));
          default -> {
            // No message.
          }
        }
      }
    }
    return lines;
  }

  /** The kind of message comes first, because space is short. */
  private static Line message(long timeNs, String whom, String channel, String message) {
    int end = 0;
    while (end < message.length() && Character.isJavaIdentifierPart(message.charAt(end))) {
      end++;
    }
    String text = message.substring(0, end) + "  " + channel + "  " + message.substring(end);
    return new Line(timeNs, whom, text, channel + "\n" + message);
  }

  /** The robot's recent actions, by their names in the paper, and log lines; latest first. */
  static List<Line> log(Recording recording, int index, RobotId robot) {
    List<Line> lines = new ArrayList<>();
    int least = Math.max(0, index - MOST_EVENTS);
    for (int i = index - 1; i >= least && lines.size() < MOST_LINES; i--) {
      TraceEvent event = recording.event(i);
      if (event.robot().equals(robot)) {
        if (event instanceof TraceEvent.Action action) {
          String text = action.name() + "(" + String.join(", ", action.args()) + ")";
          lines.add(new Line(action.timeNs(), action.source(), text, text));
        } else if (event instanceof TraceEvent.Fault fault) {
          String text = fault.name() + " " + fault.detail();
          lines.add(new Line(fault.timeNs(), "fault", text, text));
        }
      }
    }
    lines.addAll(written(recording.logs(), index, robot));
    Collections.sort(lines, (a, b) -> Long.compare(b.timeNs(), a.timeNs()));
    return lines.size() > MOST_LINES ? lines.subList(0, MOST_LINES) : lines;
  }

  private static List<Line> written(List<LogLine> all, int index, RobotId robot) {
    List<Line> lines = new ArrayList<>();
    int least = Math.max(0, all.size() - MOST_EVENTS);
    for (int i = all.size() - 1; i >= least && lines.size() < MOST_LINES; i--) {
      LogLine line = all.get(i);
      if (line.index() <= index && line.robot().equals(robot)) {
        lines.add(new Line(line.timeNs(), line.tag(), line.line(), line.line()));
      }
    }
    return lines;
  }

  /** {@code 12.345 s}. */
  static String seconds(long timeNs) {
    return String.format(Locale.ROOT, "%.3f s", timeNs / NS_PER_S);
  }
}
