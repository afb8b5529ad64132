package org.starl.sim;

import java.util.ArrayList;
import java.util.List;
import org.starl.gvh.Wait;
import org.starl.id.RobotId;
import org.starl.time.Time;

/**
 * The state of a robot whose app had not ended at the end of the run.
 *
 * @param place the source line where the app waits, as in {@code Dock.java:42 (callStarL)}; empty
 *     if the app has no thread of its own
 * @param sinceNs when this wait began
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

  /** The state in words: a first line, then details, indented. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    String none = condition.isEmpty() ? "runs" : "waits";
    String at = place.isEmpty() ? none : "waits at " + place + " since " + Time.text(sinceNs, 3);
    lines.add(robot + " " + at + (condition.isEmpty() ? "" : " for: " + condition));
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
