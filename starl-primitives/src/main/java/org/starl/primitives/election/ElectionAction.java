// Generated from Election_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.election;

import java.util.List;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of Election_decls. */
public sealed interface ElectionAction extends Action {

  record do_election(ProcessId i) implements ElectionAction {}

  record candidate(ProcessId i, long n) implements ElectionAction {}

  record elect(long n, ProcessId i) implements ElectionAction {}

  record learn(ProcessId i, long n) implements ElectionAction {}

  record fail(ProcessId i) implements ElectionAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case do_election a -> List.of(a.i);
      case candidate a -> List.of(a.i, a.n);
      case elect a -> List.of(a.n, a.i);
      case learn a -> List.of(a.i, a.n);
      case fail a -> List.of(a.i);
    };
  }
}
