package org.starl.lang.check;

import java.util.List;
import java.util.Set;
import org.starl.lang.tree.Pos;

/**
 * A false invariant, an operation that has no value, or a deadlock, in a state that can be reached; or
 * a run in which something does not happen.
 *
 * @param name of the invariant or progress; empty if it is a step that has no value
 * @param what is wrong with it: {@code is false after 4 steps}
 * @param steps the number of steps to the state
 * @param story a shortest run to it: the start state if it is one of several, then the steps, numbered; of a
 *     progress also what goes on for ever after it
 * @param actions the names of the actions of these steps
 * @param automaton in whose source {@code pos} is
 * @param pos of what is false, or has no value
 * @param message what is wrong there
 * @param unasked the assumptions, or the start, that are not decided of the run's first state: then this may
 *     be no run
 */
public record Finding(
    String name,
    String what,
    int steps,
    List<String> story,
    Set<String> actions,
    String automaton,
    Pos pos,
    String message,
    Set<String> unasked) {}
