package org.starl.spec.automaton;

/**
 * An executable version of a PVS theory's automaton. States are immutable values; {@code start},
 * {@code enabled} and {@code trans} are the theory's functions of these names, written to be
 * compared with them line by line. A {@link Replay} takes the trace of a run through it.
 *
 * @param <S> the theory's {@code states}, a record with components of the same names
 * @param <A> the theory's {@code actions}, a sealed interface with records of the same names
 */
public interface Automaton<S, A extends Action> {

  /** The theory's name, such as {@code Mutex_decls}. */
  String theory();

  /** The start state; if the theory has several, the one in which runs begin. */
  S start();

  /** Whether {@code action} is enabled in {@code state}, and if not, why. */
  Enabled enabled(A action, S state);

  /**
   * The state after {@code action} in {@code state}; computed even if the action is not enabled.
   */
  S trans(A action, S state);
}
