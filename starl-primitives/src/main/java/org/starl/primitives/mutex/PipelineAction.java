// Generated from Pipeline_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.mutex;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of Pipeline_decls. */
public sealed interface PipelineAction extends Action {

  record do_sequence(RobotId i, List<String> L, long t) implements PipelineAction {}

  /** access to the next zone */
  record grant(RobotId i, String z) implements PipelineAction {}

  record release(RobotId i, SortedSet<String> RS) implements PipelineAction {}

  /** the request ends: what was granted stays held */
  record withdraw(RobotId i) implements PipelineAction {}

  /** i's program begins anew, after a crash */
  record restart(RobotId i) implements PipelineAction {}

  /** the program says where its body stands */
  record stands_in(RobotId i, SortedSet<String> RS) implements PipelineAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_sequence a -> List.of(a.i, a.L, a.t);
      case grant a -> List.of(a.i, a.z);
      case release a -> List.of(a.i, a.RS);
      case withdraw a -> List.of(a.i);
      case restart a -> List.of(a.i);
      case stands_in a -> List.of(a.i, a.RS);
    };
  }
}
