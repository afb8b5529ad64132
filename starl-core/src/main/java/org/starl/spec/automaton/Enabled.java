package org.starl.spec.automaton;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.spec.Monitor.Report;

/**
 * The value of an enabling condition, a conjunction as in the theory: true, or the first false
 * conjunct, with the values that make it false.
 */
public final class Enabled {

  /** For an action that is always enabled. */
  public static final Enabled TRUE = new Enabled(null, "", null);

  private final @Nullable Enabled before;
  private final String conjunct;
  // Of the last conjunct if it is false; null if it is true. Asked for only in messages: most false
  // conditions are tries.
  private final @Nullable Supplier<String> values;

  private Enabled(@Nullable Enabled before, String conjunct, @Nullable Supplier<String> values) {
    this.before = before;
    this.conjunct = conjunct;
    this.values = values;
  }

  /**
   * A condition of one conjunct.
   *
   * @param conjunct its text in the source
   * @param values the values in it, asked for only by {@link #falseConjunct}
   */
  public static Enabled when(String conjunct, boolean holds, Supplier<String> values) {
    return TRUE.and(conjunct, holds, values);
  }

  /** A condition of one conjunct: a step of a used automaton is enabled. */
  public static Enabled when(String conjunct, Enabled step) {
    return TRUE.and(conjunct, step);
  }

  /** Adds a conjunct; after a false one it is not evaluated. */
  public Enabled and(String added, boolean holds, Supplier<String> addedValues) {
    return isTrue() ? new Enabled(this, added, holds ? null : addedValues) : this;
  }

  /** Adds a conjunct that may have no value after a false one. */
  public Enabled and(String added, BooleanSupplier holds, Supplier<String> addedValues) {
    return isTrue() ? and(added, holds.getAsBoolean(), addedValues) : this;
  }

  /** Adds a conjunct: a step of a used automaton is enabled. */
  public Enabled and(String added, Enabled step) {
    return and(added, step.isTrue(), step::falseConjunct);
  }

  public boolean isTrue() {
    return values == null;
  }

  /** {@code req_set(i) = {} is false: req_set(bot1) = [A]}; empty if it is true. */
  public String falseConjunct() {
    if (values == null) {
      return "";
    }
    String shown = values.get();
    return conjunct + " is false" + (shown.isEmpty() ? "" : ": ") + shown;
  }

  /** Reports the evaluated conjuncts: all true, but the last one of a condition that is false. */
  void report(String theory, Class<?> action, Report report) {
    for (Enabled at = this; at.before != null; at = at.before) {
      report.evaluated(theory, action, at.conjunct, at.isTrue());
    }
  }

  /** {@code true}, or the {@link #falseConjunct}. */
  @Override
  public String toString() {
    return isTrue() ? "true" : falseConjunct();
  }
}
