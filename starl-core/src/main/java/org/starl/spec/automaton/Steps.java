package org.starl.spec.automaton;

import org.starl.trace.TraceEvent;

/**
 * Receives the steps of runs one by one, before they are checked: a run's last step, and its last
 * result, may deviate from the automaton.
 */
public interface Steps<S, A extends Action> {

  /**
   * A run did {@code action}, which leads to {@code after}.
   *
   * @param instance the run: {@code mutex/crossing}
   * @param event the trace event that shows the action
   */
  void stepped(String instance, TraceEvent event, A action, S after);

  /**
   * The trace has a result of the latest step.
   *
   * @param function a function of the theory, of an argument and a state: {@code crit_set}
   * @param value its value at {@code argument} in the latest state, by the trace
   */
  void resulted(String instance, String function, Object argument, Object value);

  /** Ignores all steps. */
  static <S, A extends Action> Steps<S, A> ignored() {
    return new Steps<>() {
      @Override
      public void stepped(String instance, TraceEvent event, A action, S after) {}

      @Override
      public void resulted(String instance, String function, Object argument, Object value) {}
    };
  }
}
