// Generated from Barrier_decls.starl by 'starl compile': change that file instead.
package org.starl.primitives.barrier;

import java.util.List;
import org.starl.id.ProcessId;
import org.starl.primitives.barrier.BarrierAutomaton.Outcome;
import org.starl.spec.automaton.Action;

/** The actions of Barrier_decls. */
public sealed interface BarrierAction extends Action {

  record arrive(ProcessId i, long g) implements BarrierAction {}

  record decide(long g, Outcome o) implements BarrierAction {}

  record tell(ProcessId i, long g) implements BarrierAction {}

  @Override
  default List<Object> args() {
    return switch (this) {
      case arrive a -> List.of(a.i, a.g);
      case decide a -> List.of(a.g, a.o);
      case tell a -> List.of(a.i, a.g);
    };
  }
}
