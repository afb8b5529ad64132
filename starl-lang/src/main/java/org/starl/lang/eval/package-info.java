/**
 * The meaning of the language, for small sizes: an {@link org.starl.lang.eval.Machine} has the start
 * states of an automaton, the steps of a state, and its invariants.
 *
 * <p>Types are finite here ({@link org.starl.lang.eval.Domain}): opaque types have as many elements as
 * {@link org.starl.lang.eval.Sizes} says, numbers and lengths of lists are bounded. A value beyond the
 * bounds ends its evaluation by {@link org.starl.lang.eval.Beyond}; a partial operation without a
 * value, such as {@code the(none)}, by {@link org.starl.lang.eval.EvalError}. Values are immutable,
 * and equal if they mean the same: {@link java.lang.Boolean}, {@link org.starl.lang.eval.Num}, {@link
 * org.starl.lang.eval.Id}, {@link java.util.Optional}, {@link java.math.BigInteger} for sets (a bit for
 * each element's number), {@link org.starl.lang.eval.Row} for records, maps, lists and states, and
 * {@link org.starl.lang.eval.Form} for sums.
 *
 * <p>May import: {@code org.starl.lang.tree}.
 */
@NullMarked
package org.starl.lang.eval;

import org.jspecify.annotations.NullMarked;
