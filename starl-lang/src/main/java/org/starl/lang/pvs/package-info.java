/**
 * Makes a PVS theory of an automaton: {@link org.starl.lang.pvs.PvsTheory#of}. The theory declares the
 * automaton (its states, actions, {@code enabled}, {@code trans}, {@code start}), its functions, and the
 * predicates that are to be invariants; comments are kept. What is proved of it stands in another
 * theory, which imports this one. The same automaton gives the same text.
 *
 * <p>Sets become predicates, an option becomes a {@code lift}, a sum becomes a {@code DATATYPE}, and
 * {@code time} becomes {@code nonneg_real}. A function that reads the state gets the state as its last
 * argument, {@code s}. Not checked here, but by PVS: types that depend on values ({@code g - 1} is
 * natural), and names that are words of PVS ({@code by}, {@code end}).
 *
 * <p>May import: {@code org.starl.lang.tree}.
 */
@NullMarked
package org.starl.lang.pvs;

import org.jspecify.annotations.NullMarked;
