package org.starl.spec.automaton;

import org.starl.trace.TraceEvent;

/** Takes the steps of runs, one by one, after each was found to be one of the automaton. */
public interface Steps<S, A extends Action> {

  /**
   * A run did {@code action}, which led to {@code after}.
   *
   * @param instance the run: {@code mutex/crossing}
   * @param event which was taken for the action
   */
  void stepped(String instance, TraceEvent event, A action, S after);

  /**
   * The trace has a result of the latest step, which is what the state has as well.
   *
   * @param component of the theory's states, a function: {@code crit_set}
   * @param argument at which it has the {@code value}
   */
  void resulted(String instance, String component, Object argument, Object value);

  /** Takes nothing. */
  static <S, A extends Action> Steps<S, A> ignored() {
    return new Steps<>() {
      @Override
      public void stepped(String instance, TraceEvent event, A action, S after) {}

      @Override
      public void resulted(String instance, String component, Object argument, Object value) {}
    };
  }
}
