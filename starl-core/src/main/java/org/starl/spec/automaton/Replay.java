package org.starl.spec.automaton;

import java.util.List;
import java.util.function.UnaryOperator;
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent;

/**
 * Replays one instance's run on its automaton, action by action. The lemma has the theory's name:
 * it holds as long as the run is a run of the automaton. After the first deviation, nothing more of
 * this instance is checked.
 */
public final class Replay<S, A extends Action> {

  private final Automaton<S, A> automaton;
  private final String instance;
  private final Steps<S, A> steps;
  private S state;
  private boolean isOver;

  /**
   * @param instance names the instance in violations: {@code mutex/crossing}
   */
  public Replay(Automaton<S, A> automaton, String instance, Steps<S, A> steps) {
    this.automaton = automaton;
    this.instance = instance;
    this.steps = steps;
    state = automaton.start();
  }

  /** The instance, such as {@code mutex/crossing}. */
  public String instance() {
    return instance;
  }

  /** The current state. */
  public S state() {
    return state;
  }

  /** Whether the run has deviated from the automaton. */
  public boolean isOver() {
    return isOver;
  }

  /** Processes {@code action}, which {@code event} shows. */
  public void step(TraceEvent event, A action, Report report) {
    if (isOver) {
      return;
    }
    report.checked(automaton.theory());
    Enabled enabled = automaton.enabled(action, state);
    state = automaton.trans(action, state);
    steps.stepped(instance, event, action, state);
    if (!enabled.isTrue()) {
      deviates(event, action.text() + " is not enabled: " + enabled.obstacle(), report);
    }
  }

  /**
   * Processes a result of the latest step, which {@code event} shows.
   *
   * @param function a function of the theory, of an argument and a state: {@code crit_set}
   * @param recorded its value at {@code argument} in the trace
   * @param expected its value at {@code argument} in the {@link #state}
   */
  public <V> void result(
      TraceEvent event, String function, Object argument, V recorded, V expected, Report report) {
    if (isOver) {
      return;
    }
    report.checked(automaton.theory());
    steps.resulted(instance, function, argument, recorded);
    if (!recorded.equals(expected)) {
      String of = function + "(" + argument + ")";
      deviates(event, of + " is " + expected + ", but the trace has " + recorded, report);
    }
  }

  /** Reduces the state to what later steps and results need, to save memory in a long run. */
  public void forget(UnaryOperator<S> less) {
    state = less.apply(state);
  }

  private void deviates(TraceEvent event, String how, Report report) {
    isOver = true;
    report.violated(
        automaton.theory(), event.timeNs(), List.of(event.robot()), instance + ": " + how);
  }
}
