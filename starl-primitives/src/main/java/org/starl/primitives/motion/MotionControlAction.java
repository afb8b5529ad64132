package org.starl.primitives.motion;

import java.util.List;
import org.starl.RobotId;
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
  record do_move(RobotId i, long t, long A) implements MotionControlAction {
    @Override
    public List<Object> args() {
      return List.of(i, t, A);
    }
  }

  /** Its body moves, whatever the cause. */
  record move(RobotId i, Place p) implements MotionControlAction {
    @Override
    public List<Object> args() {
      return List.of(i, p);
    }
  }

  /** Says DONE. */
  record arrived(RobotId i) implements MotionControlAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** Says FAIL. */
  record failed(RobotId i) implements MotionControlAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }

  /** Takes the last command back. */
  record motion_stop(RobotId i) implements MotionControlAction {
    @Override
    public List<Object> args() {
      return List.of(i);
    }
  }
}
