package org.starl.spec.automaton;

import org.starl.trace.TraceEvent;

/**
 * Takes the steps of runs, one by one, as they are claimed: the last one of a run, and its last
 * result, may turn out to be none of the automaton's.
 */
public interface Steps<S, A extends Action> {

  /**
   * A run did {@code action}, which leads to {@code after}.
   *
   * @param instance the run: {@code mutex/crossing}
   * @param event which was taken for the action
   */
  void stepped(String instance, TraceEvent event, A action, S after);

  /**
   * The trace has a result of the latest step.
   *
   * @param function of the theory, of an argument and a state: {@code crit_set}
   * @param value which it has at {@code argument} in the latest state, by the trace
   */
  void resulted(String instance, String function, Object argument, Object value);

  /** Takes nothing. */
  static <S, A extends Action> Steps<S, A> ignored() {
    return new Steps<>() {
      @Override
      public void stepped(String instance, TraceEvent event, A action, S after) {}

      @Override
      public void resulted(String instance, String function, Object argument, Object value) {}
    };
  }
}
