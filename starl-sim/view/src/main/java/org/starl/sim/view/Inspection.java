package org.starl.sim.view;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.shape.Shape;
import org.starl.sim.record.MessageText;
import org.starl.sim.record.Scene;
import org.starl.sim.replay.LogLine;
import org.starl.sim.replay.Recording;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/** State, messages and log of one robot at a moment of a recording, computed on demand. */
public final class Inspection {

  private static final int MOST_LINES = 60;
  private static final int MOST_EVENTS = 60_000;

  private Inspection() {}

  /**
   * A row of a table.
   *
   * @param isTitle whether it is the title of a group; its value is then empty
   */
  public record Row(boolean isTitle, String name, String value) {}

  /**
   * A message or a line of the log.
   *
   * @param more the full text
   */
  record Line(long timeNs, String what, String text, String more) {}

  /** The pose, then the variables of the app, of motion and of each primitive. */
  public static List<Row> state(Scene scene, RobotId robot) {
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
    rows.add(new Row(false, "program", scene.isDown(robot) ? "crashed" : "running"));
    Instance source = null;
    List<Variable> variables = new ArrayList<>(scene.variables(robot));
    variables.sort(Comparator.comparingInt(Inspection::rank));
    for (Variable variable : variables) {
      if (!variable.source().equals(source)) {
        source = variable.source();
        rows.add(new Row(true, source.name(), ""));
      }
      rows.add(new Row(false, variable.name(), variable.value().toString()));
    }
    return rows;
  }

  /** Order of sources: app, motion, primitives. */
  private static int rank(Variable variable) {
    Instance source = variable.source();
    return source.equals(Instance.APP) ? 0 : source.equals(MotionFact.SOURCE) ? 1 : 2;
  }

  private static String mm(double mm) {
    return String.format(Locale.ROOT, "%.0f mm", mm);
  }

  /** Recent messages that the robot sent, received or missed, latest first. */
  static List<Line> messages(Recording recording, int index, RobotId robot) {
    return latest(recording, index, robot, Inspection::message);
  }

  private static @Nullable Line message(TraceEvent event) {
    return switch (event) {
      case Sent out -> {
        String to = out.to().equals(Sent.ALL) ? "all" : out.to();
        yield message(out.timeNs(), "\u2192 " + to, out.channel(), out.shape(), out.message());
      }
      case Delivered in ->
          message(in.timeNs(), "\u2190 " + in.from(), in.channel(), in.shape(), in.message());
      case Dropped lost -> new Line(lost.timeNs(), "\u2715 " + lost.from(), lost.why(), lost.why());
      default -> null;
    };
  }

  /** The message's type comes first, as the column may be narrow. */
  private static Line message(
      long timeNs, String peer, Instance channel, Shape<?> shape, Object content) {
    MessageText message = MessageText.of(shape, content, Set.of());
    String text = message.name() + "  " + channel + "  " + message.parts();
    return new Line(timeNs, peer, text.strip(), channel + "\n" + message);
  }

  /** Recent actions, by the paper's names, faults and log lines, latest first. */
  static List<Line> log(Recording recording, int index, RobotId robot) {
    List<Line> lines = latest(recording, index, robot, Inspection::action);
    lines.addAll(written(recording.logs(), index, robot));
    lines.sort((a, b) -> Long.compare(b.timeNs(), a.timeNs()));
    return lines.size() > MOST_LINES ? lines.subList(0, MOST_LINES) : lines;
  }

  private static @Nullable Line action(TraceEvent event) {
    return switch (event) {
      case TraceEvent.Action action -> {
        String text =
            action.args().stream()
                .map(String::valueOf)
                .collect(Collectors.joining(", ", action.name() + "(", ")"));
        yield new Line(action.timeNs(), action.source().name(), text, text);
      }
      case TraceEvent.Fault fault -> {
        String text = fault.name() + " " + fault.detail();
        yield new Line(fault.timeNs(), "fault", text, text);
      }
      default -> null;
    };
  }

  /** The lines of the robot's latest events before {@code index}; null lines are left out. */
  private static List<Line> latest(
      Recording recording, int index, RobotId robot, Function<TraceEvent, @Nullable Line> line) {
    List<Line> lines = new ArrayList<>();
    int least = Math.max(0, index - MOST_EVENTS);
    for (int i = index - 1; i >= least && lines.size() < MOST_LINES; i--) {
      TraceEvent event = recording.event(i);
      Line shown = event.robot().equals(robot) ? line.apply(event) : null;
      if (shown != null) {
        lines.add(shown);
      }
    }
    return lines;
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
    return String.format(Locale.ROOT, "%.3f s", Time.seconds(timeNs));
  }
}
