package org.starl.primitives.motion;

import org.starl.geometry.Point;
import org.starl.trace.TraceEvent.Variable;

/** The names of motions in the trace; {@link MotionSpec} reads them. */
public final class MotionTrace {

  static final String SOURCE = "motion";

  /** Action with the target: a command to this primitive. */
  static final String GOTOPOINT = "gotopoint";

  /** Action with the target and the region to avoid: a command to this primitive. */
  static final String DO_MOVE = "do_move";

  /** Like {@link #DO_MOVE}, for the motion automaton below, which apps may also use directly. */
  static final String MOAT_MOVE = "doMove";

  /** Action with the target that the robot must face. */
  static final String TURN_TO = "turnTo";

  static final String MOTION_STOP = "motion_stop";

  /** Action with x and y of the estimated position, and its error bound, in mm: DONE. */
  static final String ARRIVED = "arrived";

  /** Action with the reason as text: FAIL. */
  static final String FAILED = "failed";

  static final String MOTIONFLAG = "motionflag";

  private MotionTrace() {}

  /** Whether the variable is a robot's {@code motionflag}. */
  public static boolean isFlag(Variable variable) {
    return variable.source().equals(SOURCE) && variable.name().equals(MOTIONFLAG);
  }

  /** The place in a target's text {@code name@x,y}. */
  static Point place(String target) {
    int comma = target.lastIndexOf(',');
    int at = target.lastIndexOf('@', comma);
    return new Point(
        Double.parseDouble(target.substring(at + 1, comma)),
        Double.parseDouble(target.substring(comma + 1)));
  }
}
