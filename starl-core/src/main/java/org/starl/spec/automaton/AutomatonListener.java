package org.starl.spec.automaton;

import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * Receives every step and result that a {@link Replay} checks, before it is known whether it deviates.
 * So the last one of a run may be a deviation.
 */
public interface AutomatonListener<S, A extends Action> {

  /**
   * An instance took {@code action}.
   *
   * @param instance {@code mutex/crossing}
   * @param event the event that was mapped to the action
   * @param after the state after it
   */
  void onStep(Instance instance, TraceEvent event, A action, S after);

  /**
   * The trace records a result of the latest step.
   *
   * @param function of the theory, of an argument and a state: {@code crit_set}
   * @param value its value at {@code argument} in the latest state, by the trace
   */
  void onResult(Instance instance, String function, Object argument, Object value);

  /** Ignores everything. */
  static <S, A extends Action> AutomatonListener<S, A> none() {
    return new AutomatonListener<>() {
      @Override
      public void onStep(Instance instance, TraceEvent event, A action, S after) {}

      @Override
      public void onResult(Instance instance, String function, Object argument, Object value) {}
    };
  }
}
