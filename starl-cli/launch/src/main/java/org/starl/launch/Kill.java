package org.starl.launch;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The time at which a process is killed: {@code bot2@12s}, 12 s after the begin; {@code
 * bot2@app.location=MOVE_WAIT}, when that variable of its trace first has that value; {@code
 * bot2@app.location=MOVE_WAIT+1500ms}, 1.5 s after that.
 *
 * @param variable {@code SOURCE.NAME=VALUE}, or null for a time of the run
 * @param afterNs after the variable first has that value, or after the begin
 */
public record Kill(RobotId robot, @Nullable String variable, long afterNs) {

  private static final String EXPECTED =
      "expected ROBOT@WHEN, such as bot2@12s or bot2@app.location=MOVE_WAIT+1500ms";

  /**
   * @throws BadInput if {@code text} has none of these forms
   */
  public static Kill parse(String text) {
    int at = text.indexOf('@');
    if (at < 0 || !RobotId.isValid(text.substring(0, at))) {
      throw new BadInput("--kill: " + BadInput.quote(text) + ": " + EXPECTED);
    }
    RobotId robot = new RobotId(text.substring(0, at));
    String when = text.substring(at + 1);
    if (when.indexOf('=') < 0) {
      return new Kill(robot, null, durationNs(text, when));
    }
    int plus = when.lastIndexOf('+');
    String variable = plus < 0 ? when : when.substring(0, plus);
    if (variable.lastIndexOf('.', variable.indexOf('=')) <= 0) {
      throw new BadInput("--kill: " + BadInput.quote(text) + ": " + EXPECTED);
    }
    return new Kill(robot, variable, plus < 0 ? 0 : durationNs(text, when.substring(plus + 1)));
  }

  private static long durationNs(String text, String duration) {
    try {
      return Quantities.durationNs(duration);
    } catch (BadInput wrong) {
      throw new BadInput("--kill: " + BadInput.quote(text) + ": " + EXPECTED);
    }
  }

  /** Whether {@code event} gives the variable its value. */
  boolean isTriggeredBy(TraceEvent event) {
    return event instanceof Variable changed
        && changed.robot().equals(robot)
        && (changed.source() + "." + changed.name() + "=" + changed.value()).equals(variable);
  }

  @Override
  public String toString() {
    if (variable == null) {
      return robot + "@" + Quantities.durationText(afterNs);
    }
    return robot + "@" + variable + (afterNs == 0 ? "" : "+" + Quantities.durationText(afterNs));
  }
}
