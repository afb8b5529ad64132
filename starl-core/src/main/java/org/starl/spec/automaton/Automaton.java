package org.starl.spec.automaton;

/**
 * An automaton of a PVS theory, executable. States are immutable values; {@code start}, {@code
 * enabled} and {@code trans} are the theory's functions of these names, written to be read beside
 * them. The trace of a run is taken through it by a {@link Replay}.
 *
 * @param <S> the theory's {@code states}, a record of components of the same names
 * @param <A> the theory's {@code actions}, a sealed interface of records of the same names
 */
public interface Automaton<S, A extends Action> {

  /** The theory's name: {@code Mutex_decls}. */
  String theory();

  /** The start state; where the theory has several, the one in which runs begin. */
  S start();

  /** Whether {@code action} may happen in {@code state}, and if not, why. */
  Enabled enabled(A action, S state);

  /** The state that {@code action} leads to from {@code state}, as if it were enabled if it is not. */
  S trans(A action, S state);
}
