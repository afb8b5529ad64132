// Generated from MotionControl_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.motion;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of MotionControl_decls. */
public sealed interface MotionControlAction extends Action {

  record do_move(RobotId i, Place t, Area A) implements MotionControlAction {}

  record move(RobotId i, Place p) implements MotionControlAction {}

  record arrived(RobotId i) implements MotionControlAction {}

  record failed(RobotId i) implements MotionControlAction {}

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
