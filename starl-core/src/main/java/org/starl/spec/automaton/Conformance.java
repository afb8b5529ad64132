package org.starl.spec.automaton;

import java.util.function.Function;
import org.starl.spec.InstanceMonitor;
import org.starl.trace.Instance;

/**
 * Checks that every run of every instance of a primitive is a run of its theory's automaton. The lemma
 * is the theory's name. A subclass is the map from trace events to actions: it steps the {@link
 * Replay} of an instance, and compares the results that the trace records with the automaton's. An
 * event without an action is a stutter.
 *
 * @param <R> the state kept for one instance: its {@link Replay}, or an object that holds it
 */
public abstract class Conformance<R> extends InstanceMonitor<R> {

  private final Function<Instance, R> begin;

  /**
   * @param theory its name: {@code Mutex_decls}
   * @param subject the primitive, for the user: {@code every mutex}
   * @param begin the state of an instance before its first event, by its source
   * @param kinds of its instances, as {@link InstanceMonitor} has them
   */
  @SuppressWarnings("this-escape") // a lemma only adds a row to the table of the superclass
  protected Conformance(
      String theory, String subject, Function<Instance, R> begin, String... kinds) {
    super(kinds);
    this.begin = begin;
    lemma(theory, "The run of " + subject + " is one of the theory's automaton, step by step.");
  }

  @Override
  protected final R begin(Instance source) {
    return begin.apply(source);
  }
}
