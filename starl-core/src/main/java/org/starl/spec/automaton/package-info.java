/**
 * The connection of code and proof. A primitive is proved safe in PVS as an automaton: its states,
 * the actions enabled in a state, the state after an action. {@link
 * org.starl.spec.automaton.Automaton} is the same automaton in Java, under the same names, so that
 * it can be compared with its theory in {@code pvs/}. {@link org.starl.spec.automaton.Replay} takes
 * a run of the real implementation through it: for each primitive, a mapping from trace events to
 * actions gives the actions of the run; each must be enabled in the current state, and each
 * recorded result must equal the automaton's. What is proved for all runs of the automaton then
 * holds for this run.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.spec}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.spec.automaton;

import org.jspecify.annotations.NullMarked;
