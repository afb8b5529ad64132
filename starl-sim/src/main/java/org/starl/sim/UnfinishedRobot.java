package org.starl.sim;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.RobotRunner;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Wait;
import org.starl.id.RobotId;
import org.starl.motion.MotionController;
import org.starl.sim.kernel.AppFrame;
import org.starl.time.Time;

/**
 * The state of a robot whose app has not ended: at the end of the run, or at a violation.
 *
 * @param place the line where the app is, in its source, as in {@code Dock.java:42 (callStarL)}; empty if
 *     the app has no thread of its own
 * @param isRunning whether it runs there, and does not wait
 * @param sinceNs when this wait began; -1 if that is unknown
 * @param condition the name of the awaited condition; empty if it has none
 * @param changedNs when a variable last changed; -1 if the run did not record it
 * @param variables in the form {@code source.name=value}
 * @param waits what its primitives wait for or hold
 * @param motion the state of its motion control; empty if it never moved
 * @param touches the bodies and walls that its body touches
 */
public record UnfinishedRobot(
    RobotId robot,
    String place,
    boolean isRunning,
    long sinceNs,
    String condition,
    long changedNs,
    List<String> variables,
    List<Wait> waits,
    String motion,
    List<String> touches) {

  public UnfinishedRobot {
    variables = List.copyOf(variables);
    waits = List.copyOf(waits);
    touches = List.copyOf(touches);
  }

  /**
   * The state of a robot, read on its strand.
   *
   * @param appStack of the app's thread; may be empty
   * @param isRunning whether the app runs now
   */
  public static UnfinishedRobot of(
      RobotId robot,
      RobotRunner runner,
      StackTraceElement[] appStack,
      boolean isRunning,
      long sinceNs,
      long changedNs,
      List<String> touches) {
    GlobalVarHolder gvh = runner.gvh();
    RobotApp app = runner.app();
    List<String> variables = new ArrayList<>();
    if (gvh != null) {
      for (GvhVariable<?> variable : gvh.variables()) {
        variables.add(variable.source() + "." + variable.name() + "=" + variable.get());
      }
    }
    return new UnfinishedRobot(
        robot,
        AppFrame.of(app == null ? appStack : app.inSource(appStack)),
        isRunning,
        sinceNs,
        app == null ? "the start of the program" : app.awaited(),
        changedNs,
        variables,
        gvh == null ? List.of() : gvh.waits(),
        gvh == null ? "" : motion(gvh.plat.moat),
        touches);
  }

  private static String motion(MotionController moat) {
    return switch (moat.motionflag().get()) {
      case IDLE -> "";
      case MOVING -> "moving to " + moat.target().get();
      case DONE -> "done";
      case FAIL -> "failed: " + moat.failure();
    };
  }

  /** The state in words: a first line, then details, indented. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    String none = condition.isEmpty() ? "runs" : "waits";
    String since = sinceNs < 0 ? "" : " since " + Time.text(sinceNs, 3);
    String at = place.isEmpty() ? none : "waits at " + place + since;
    if (isRunning) {
      lines.add(robot + (place.isEmpty() ? " runs" : " runs at " + place));
    } else {
      lines.add(robot + " " + at + (condition.isEmpty() ? "" : " for: " + condition));
    }
    waits.forEach(wait -> lines.add("  " + wait));
    if (!motion.isEmpty()) {
      lines.add("  motion: " + motion);
    }
    if (!touches.isEmpty()) {
      lines.add("  touches " + String.join(", ", touches));
    }
    String changed = changedNs < 0 ? "" : " (last change at " + Time.text(changedNs, 3) + ")";
    if (!variables.isEmpty()) {
      lines.add("  variables" + changed + ": " + String.join(", ", variables));
    }
    return lines;
  }

  /** The reason in one line: what it waits for, or where. */
  String brief() {
    if (!waits.isEmpty()) {
      return robot + " " + waits.get(0);
    }
    return lines().get(0) + (motion.isEmpty() ? "" : ", motion " + motion);
  }
}
