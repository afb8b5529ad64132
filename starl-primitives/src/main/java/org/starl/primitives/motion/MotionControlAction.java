package org.starl.primitives.motion;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.primitives.motion.MotionControlAutomaton.Place;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code MotionControl_decls}, under their names there. */
public sealed interface MotionControlAction extends Action {

  /**
   * A command to go to {@code t} outside {@code A}.
   *
   * @param t the number of the command, for its target
   * @param A the number of the command, for its area, or {@link MotionControlAutomaton#EMPTYSET}
   */
  record do_move(RobotId i, long t, long A) implements MotionControlAction {}

  /** The robot's body moves, for any reason. */
  record move(RobotId i, Place p) implements MotionControlAction {}

  /** The robot reports DONE. */
  record arrived(RobotId i) implements MotionControlAction {}

  /** The robot reports FAIL. */
  record failed(RobotId i) implements MotionControlAction {}

  /** Cancels the last command. */
  record motion_stop(RobotId i) implements MotionControlAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_move a -> List.of(a.i, a.t, a.A);
      case move a -> List.of(a.i, a.p);
      case arrived a -> List.of(a.i);
      case failed a -> List.of(a.i);
      case motion_stop a -> List.of(a.i);
    };
  }
}
