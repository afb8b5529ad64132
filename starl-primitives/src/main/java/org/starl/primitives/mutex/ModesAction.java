// Generated from Modes_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of Modes_decls. */
public sealed interface ModesAction extends Action {

  record do_mutex(RobotId i, SortedSet<String> RS) implements ModesAction {}

  /** access, to place n */
  record grant(RobotId i, String z, long n) implements ModesAction {}

  record release(RobotId i, SortedSet<String> RS) implements ModesAction {}

  /** the request ends: what was granted stays held */
  record withdraw(RobotId i) implements ModesAction {}

  /** i's program begins anew, after a crash */
  record restart(RobotId i) implements ModesAction {}

  /** the program says where its body stands */
  record stands_in(RobotId i, SortedSet<String> RS) implements ModesAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_mutex a -> List.of(a.i, a.RS);
      case grant a -> List.of(a.i, a.z, a.n);
      case release a -> List.of(a.i, a.RS);
      case withdraw a -> List.of(a.i);
      case restart a -> List.of(a.i);
      case stands_in a -> List.of(a.i, a.RS);
    };
  }
}
