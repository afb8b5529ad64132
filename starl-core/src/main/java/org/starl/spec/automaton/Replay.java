package org.starl.spec.automaton;

import java.util.List;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.starl.spec.Monitor.Report;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * The run of one instance, replayed on its automaton action by action. The lemma is the theory's name:
 * it holds as long as the run is a run of the automaton. After the first deviation the replay is over:
 * nothing more is checked or reported for the instance.
 */
public final class Replay<S, A extends Action> {

  // Each try costs as much as a step. Primes, so that a run that repeats itself does not hide an
  // action or a state from them.
  private static final int TRY_EVERY = 7;
  private static final int CHANGE_EVERY = 11;

  private final Automaton<S, A> automaton;
  private final Instance instance;
  private final AutomatonListener<S, A> steps;
  private S state;
  // An earlier action, whose guard is tried in later states.
  private @Nullable A probe;
  private int taken;
  private boolean hasDeviated;

  /**
   * @param instance for violations: {@code mutex/crossing}
   * @param steps receives every step
   */
  public Replay(Automaton<S, A> automaton, Instance instance, AutomatonListener<S, A> steps) {
    this.automaton = automaton;
    this.instance = instance;
    this.steps = steps;
    state = automaton.start();
  }

  /** The present state. */
  public S state() {
    return state;
  }

  /** Whether the run has deviated. */
  public boolean hasDeviated() {
    return hasDeviated;
  }

  /** Takes {@code action}, as told by {@code event}; it deviates if it is not enabled. */
  public void step(TraceEvent event, A action, Report report) {
    if (hasDeviated) {
      return;
    }
    report.checked(automaton.theory());
    Enabled enabled = automaton.enabled(action, state);
    state = automaton.trans(action, state);
    if (enabled.isTrue()) {
      report.taken(automaton.theory(), action.getClass());
    }
    enabled.report(automaton.theory(), action.getClass(), report);
    tryGuard(action, report);
    steps.onStep(instance, event, action, state);
    if (!enabled.isTrue()) {
      deviate(event, action.text() + " is not enabled: " + enabled.falseConjunct(), report);
    }
  }

  /**
   * Evaluates, now and then, the guard of an earlier action in the present state: so it is known
   * which conjuncts of the guards made a difference in this run.
   */
  private void tryGuard(A action, Report report) {
    A earlier = probe;
    if (taken % TRY_EVERY == 0 && earlier != null) {
      Enabled now = automaton.enabled(earlier, state);
      now.report(automaton.theory(), earlier.getClass(), report);
    }
    if (taken % CHANGE_EVERY == 0) {
      probe = action;
    }
    taken++;
  }

  /**
   * Compares a result of the latest step, as recorded in {@code event}, with the automaton's.
   *
   * @param function of the theory, of an argument and a state: {@code crit_set}
   * @param recorded its value at {@code argument}, by the trace
   * @param expected its value there in the present {@link #state}
   */
  public <V> void result(
      TraceEvent event, String function, Object argument, V recorded, V expected, Report report) {
    if (hasDeviated) {
      return;
    }
    report.checked(automaton.theory());
    steps.onResult(instance, function, argument, recorded);
    if (!recorded.equals(expected)) {
      String of = function + "(" + argument + ")";
      deviate(event, of + " is " + expected + ", but the trace has " + recorded, report);
    }
  }

  /** Drops from the state what no later step or result reads; for long runs. */
  public void reduce(UnaryOperator<S> reduce) {
    state = reduce.apply(state);
  }

  private void deviate(TraceEvent event, String how, Report report) {
    hasDeviated = true;
    report.violated(
        automaton.theory(), event.timeNs(), List.of(event.robot()), instance + ": " + how);
  }
}
