package org.starl.primitives.election;

import java.util.List;
import org.starl.id.ProcessId;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Election_decls}, under their names there. */
public sealed interface ElectionAction extends Action {

  /** Becomes a candidate of all later terms. */
  record do_election(ProcessId i) implements ElectionAction {}

  /** Stands for election in term {@code n}. */
  record candidate(ProcessId i, long n) implements ElectionAction {}

  /** Is elected in term {@code n}; no robot need know yet. */
  record elect(long n, ProcessId i) implements ElectionAction {}

  /** Learns the leader of term {@code n}. */
  record learn(ProcessId i, long n) implements ElectionAction {}

  /** Knows no leader any longer, or is told that there is none. */
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
