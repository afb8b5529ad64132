package org.starl.primitives.motion;

import org.starl.geometry.Point;
import org.starl.trace.TraceEvent.Variable;

/** The names under which motions appear in a trace; {@link MotionSpec} decides from these. */
final class MotionTrace {

  static final String SOURCE = "motion";

  /** Action with the target: this primitive is told to go there. */
  static final String GOTOPOINT = "gotopoint";

  /** Action with the target and the region: this primitive is told to go there. */
  static final String DO_MOVE = "do_move";

  /** As {@link #DO_MOVE}, of the motion automaton below, which anybody may use. */
  static final String MOAT_MOVE = "doMove";

  /** Action with the target that the robot shall face. */
  static final String TURN_TO = "turnTo";

  static final String MOTION_STOP = "motion_stop";

  /** Action with x and y of where the robot believes to be, and its error bound, in mm: DONE. */
  static final String ARRIVED = "arrived";

  /** Action with the reason in words: FAIL. */
  static final String FAILED = "failed";

  static final String MOTIONFLAG = "motionflag";

  private MotionTrace() {}

  /** Whether it is some robot's {@code motionflag}. */
  static boolean isFlag(Variable variable) {
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
