package org.starl.lang.check;

import java.util.List;
import org.starl.lang.tree.Pos;

/**
 * A false invariant, or an operation that has no value, in a state that can be reached.
 *
 * @param invariant empty if it is a step that has no value
 * @param steps the number of steps to the state
 * @param story a shortest run to it: the start state if it is one of several, then the steps, numbered
 * @param automaton in whose source {@code pos} is
 * @param pos of what is false, or has no value
 * @param isFalse whether the invariant is false there; else an operation has no value
 * @param message what is wrong there
 */
public record Finding(
    String invariant,
    int steps,
    List<String> story,
    String automaton,
    Pos pos,
    boolean isFalse,
    String message) {}
