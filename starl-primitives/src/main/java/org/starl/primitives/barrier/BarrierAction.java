package org.starl.primitives.barrier;

import java.util.List;
import org.starl.ProcessId;
import org.starl.primitives.barrier.BarrierAutomaton.Outcome;
import org.starl.spec.automaton.Action;

/** The actions of the theory {@code Barrier_decls}, under their names there. */
public sealed interface BarrierAction extends Action {

  /** Arrives in generation {@code g}. */
  record arrive(ProcessId i, long g) implements BarrierAction {
    @Override
    public List<Object> args() {
      return List.of(i, g);
    }
  }

  /** Generation {@code g} has its outcome, which nobody need know of. */
  record decide(long g, Outcome o) implements BarrierAction {
    @Override
    public List<Object> args() {
      return List.of(g, o);
    }
  }

  /** Is told the outcome of generation {@code g}. */
  record tell(ProcessId i, long g) implements BarrierAction {
    @Override
    public List<Object> args() {
      return List.of(i, g);
    }
  }
}
