package org.starl.primitives.barrier;

import java.util.List;
import org.starl.id.ProcessId;
import org.starl.primitives.barrier.BarrierAutomaton.Outcome;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Barrier_decls}, under their names there. */
public sealed interface BarrierAction extends Action {

  /** Arrives in generation {@code g}. */
  record arrive(ProcessId i, long g) implements BarrierAction {}

  /** The outcome of generation {@code g} is decided; no robot need know yet. */
  record decide(long g, Outcome o) implements BarrierAction {}

  /** Is told the outcome of generation {@code g}. */
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
