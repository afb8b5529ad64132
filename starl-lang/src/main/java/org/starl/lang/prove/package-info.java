/**
 * Proves invariants by the solver Z3. {@link org.starl.lang.prove.Prover} makes obligations of an automaton, texts in
 * SMT-LIB 2: each invariant holds in each start state, and each action keeps it, where all invariants that are kept
 * hold before. What Z3 decides for opaque types of any number of elements holds for any number of robots; what it
 * does not decide is tried with few elements. Its limit is a number of steps, not a time, so that a result does not
 * depend on the machine.
 *
 * <p>May import: {@code org.starl.lang.tree}, {@code org.starl.lang.verdict}, Z3.
 */
@NullMarked
package org.starl.lang.prove;

import org.jspecify.annotations.NullMarked;
