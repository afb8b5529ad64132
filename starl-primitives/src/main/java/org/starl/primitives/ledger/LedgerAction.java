// Generated from Ledger_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.ledger;

import java.util.List;
import org.starl.id.RobotId;
import org.starl.spec.automaton.Action;

/** The actions of Ledger_decls. */
public sealed interface LedgerAction extends Action {

  record insert(TaskId t) implements LedgerAction {}

  record take(RobotId i, TaskId t, long n) implements LedgerAction {}

  record commit(RobotId i, TaskId t, long n) implements LedgerAction {}

  record finish(RobotId i, TaskId t, long n) implements LedgerAction {}

  record free(TaskId t, long n) implements LedgerAction {}

  record reopen(TaskId t, long n) implements LedgerAction {}

  record tell(RobotId i, TaskId t, long n) implements LedgerAction {}

  record restart(RobotId i) implements LedgerAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case insert a -> List.of(a.t);
      case take a -> List.of(a.i, a.t, a.n);
      case commit a -> List.of(a.i, a.t, a.n);
      case finish a -> List.of(a.i, a.t, a.n);
      case free a -> List.of(a.t, a.n);
      case reopen a -> List.of(a.t, a.n);
      case tell a -> List.of(a.i, a.t, a.n);
      case restart a -> List.of(a.i);
    };
  }
}
