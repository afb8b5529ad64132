package org.starl.spec.automaton;

import java.util.function.Supplier;

/**
 * The value of an enabling condition, a conjunction as in the theory: true, or the first false
 * conjunct, with the values that make it false.
 */
public final class Enabled {

  /** For an action that is always enabled. */
  public static final Enabled TRUE = new Enabled("", "");

  private final String conjunct;
  private final String values;

  private Enabled(String conjunct, String values) {
    this.conjunct = conjunct;
    this.values = values;
  }

  /**
   * A condition of one conjunct.
   *
   * @param conjunct its text in the theory
   * @param values the values in it, asked for only if it is false: {@code req_set(bot1) = [A]}
   */
  public static Enabled when(String conjunct, boolean holds, Supplier<String> values) {
    return TRUE.and(conjunct, holds, values);
  }

  /** Adds a conjunct. */
  public Enabled and(String conjunct, boolean holds, Supplier<String> values) {
    return holds || !isTrue() ? this : new Enabled(conjunct, values.get());
  }

  public boolean isTrue() {
    return conjunct.isEmpty();
  }

  /** {@code empty?(req_set(i, s)) is false: req_set(bot1) = [A]}; empty if it is true. */
  public String falseConjunct() {
    return isTrue() ? "" : conjunct + " is false: " + values;
  }

  /** The first false conjunct as in the theory, without its values; empty if it is true. */
  public String conjunct() {
    return conjunct;
  }

  /** {@code true}, or the {@link #falseConjunct}. */
  @Override
  public String toString() {
    return isTrue() ? "true" : falseConjunct();
  }
}
