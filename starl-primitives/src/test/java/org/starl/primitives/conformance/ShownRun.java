package org.starl.primitives.conformance;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.spec.SpecReport.Violation;
import org.starl.spec.automaton.Action;
import org.starl.spec.automaton.AutomatonListener;
import org.starl.spec.automaton.Conformance;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/** A run that a {@link Conformance} is shown event by event, and what it takes the events for. */
public final class ShownRun<S, A extends Action> {

  private final List<String> steps = new ArrayList<>();
  private final List<String> instances = new ArrayList<>();
  private final List<S> states = new ArrayList<>();
  private final Monitors monitors;

  /**
   * @param conformance made with what takes its steps
   */
  public ShownRun(Function<AutomatonListener<S, A>, ? extends Conformance<?>> conformance) {
    Monitor monitor =
        conformance.apply(
            new AutomatonListener<S, A>() {
              @Override
              public void onStep(Instance instance, TraceEvent event, A action, S after) {
                steps.add(action.text());
                instances.add(instance.name());
                states.add(after);
              }

              @Override
              public void onResult(
                  Instance instance, String function, Object argument, Object value) {
                steps.add(function + "(" + argument + ") = " + value);
              }
            });
    monitors = new Monitors(List.of(monitor));
  }

  /** Its next event. */
  public void has(TraceEvent event) {
    monitors.observe(event);
  }

  /** Ends the run. */
  public void ends(long timeNs) {
    monitors.finish(timeNs);
  }

  /** Actions, {@code do_mutex(i, [A])}, and results, {@code crit_set(i) = [A]}. */
  public List<String> steps() {
    return List.copyOf(steps);
  }

  /** Of each action, {@code mutex/x}. */
  public List<String> instances() {
    return List.copyOf(instances);
  }

  /** After the latest action. */
  public S state() {
    return states.get(states.size() - 1);
  }

  /** Of the steps so far nothing more is told. */
  public void forgetSteps() {
    steps.clear();
    instances.clear();
  }

  public SpecReport report() {
    return monitors.report();
  }

  /** How it is no run of the theory. */
  public List<String> details() {
    return report().violations().stream().map(Violation::detail).toList();
  }
}
