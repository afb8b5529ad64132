// Generated from Synod_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.agreement;

import java.util.List;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodAutomaton.Ballot;
import org.starl.spec.automaton.Action;

/** The actions of Synod_decls. */
public sealed interface SynodAction extends Action {

  /** SetAgreement.propose */
  record wish(RobotId r, Value v) implements SynodAction {}

  /** a new ballot */
  record prepare(ProcessId i, long n) implements SynodAction {}

  /** an acceptor promises */
  record Prepared(RobotId r, Ballot b) implements SynodAction {}

  /** the quorum Q has promised: ask for votes */
  record Propose(ProcessId i, Value v, SortedSet<RobotId> Q) implements SynodAction {}

  /** an acceptor votes */
  record Accept(RobotId r, Ballot b, Value v) implements SynodAction {}

  /** the proposer sees that the quorum Q voted */
  record chosen(ProcessId i, Value v, SortedSet<RobotId> Q) implements SynodAction {}

  record Learn(RobotId r, Value v) implements SynodAction {}

  record restart(RobotId r) implements SynodAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case wish a -> List.of(a.r, a.v);
      case prepare a -> List.of(a.i, a.n);
      case Prepared a -> List.of(a.r, a.b);
      case Propose a -> List.of(a.i, a.v, a.Q);
      case Accept a -> List.of(a.r, a.b, a.v);
      case chosen a -> List.of(a.i, a.v, a.Q);
      case Learn a -> List.of(a.r, a.v);
      case restart a -> List.of(a.r);
    };
  }
}
