package org.starl.spec.automaton;

import java.util.List;
import java.util.function.UnaryOperator;
import org.starl.spec.Monitor.Report;
import org.starl.trace.TraceEvent;

/**
 * One instance's run, taken through its automaton action by action. The lemma is the theory's name:
 * it holds as long as this is a run of the theory's automaton. After the first step that is none,
 * nothing more is said of the instance.
 */
public final class Replay<S, A extends Action> {

  private final Automaton<S, A> automaton;
  private final String instance;
  private final Steps<S, A> steps;
  private S state;
  private boolean isOver;

  /**
   * @param instance for violations: {@code mutex/crossing}
   */
  public Replay(Automaton<S, A> automaton, String instance, Steps<S, A> steps) {
    this.automaton = automaton;
    this.instance = instance;
    this.steps = steps;
    state = automaton.start();
  }

  /** {@code mutex/crossing}. */
  public String instance() {
    return instance;
  }

  /** Where the run stands. */
  public S state() {
    return state;
  }

  /** Whether a step was no step of the automaton. */
  public boolean isOver() {
    return isOver;
  }

  /** The run does {@code action}, as {@code event} tells. */
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
   * The trace has a result of the latest step, in {@code event}.
   *
   * @param function of the theory, of an argument and a state: {@code crit_set}
   * @param recorded what it is at {@code argument}, by the trace
   * @param expected what it is there in the {@link #state}
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

  /** Forgets what no step and no result to come looks at, in a run that may be long. */
  public void forget(UnaryOperator<S> less) {
    state = less.apply(state);
  }

  private void deviates(TraceEvent event, String how, Report report) {
    isOver = true;
    report.violated(
        automaton.theory(), event.timeNs(), List.of(event.robot()), instance + ": " + how);
  }
}
