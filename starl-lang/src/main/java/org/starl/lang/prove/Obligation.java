package org.starl.lang.prove;

import org.starl.lang.tree.Pos;

/**
 * What must hold so that an expression has a value, or an action an effect.
 *
 * @param condition closed, for Z3
 * @param otherwise what is wrong where it does not hold
 * @param pos of the operation that needs it
 */
record Obligation(String condition, String otherwise, Pos pos) {}
