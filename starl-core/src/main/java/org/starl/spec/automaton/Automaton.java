package org.starl.spec.automaton;

/**
 * An executable automaton of a PVS theory. States are immutable values; {@code start}, {@code
 * enabled} and {@code trans} are the theory's functions of these names, written to be read beside
 * them. A {@link Replay} runs a trace through it.
 *
 * @param <S> the theory's {@code states}, a record of components of the same names
 * @param <A> the theory's {@code actions}, a sealed interface of records of the same names
 */
public interface Automaton<S, A extends Action> {

  /** The theory's name: {@code Mutex_decls}. */
  String theory();

  /** The start state; where the theory has several, the one that runs begin in. */
  S start();

  /** Whether {@code action} is enabled in {@code state}, and if not, why. */
  Enabled enabled(A action, S state);

  /** The state after {@code action} in {@code state}; {@code action} need not be enabled. */
  S trans(A action, S state);
}
