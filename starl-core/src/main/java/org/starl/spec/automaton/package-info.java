/**
 * Ties code to proofs. A primitive is proved safe in PVS as an automaton: its states, the actions that
 * a state enables, and the state after each action. {@link org.starl.spec.automaton.Automaton} is the
 * same automaton in Java, under the same names, so that both can be read side by side; the theories
 * are in {@code pvs/}. A {@link org.starl.spec.automaton.Conformance} maps the trace events of a
 * primitive to actions, and replays each run of the real implementation on the automaton: each action
 * must be enabled in the present state, and each result in the trace must equal the automaton's. What
 * is proved of all runs of the automaton then holds for this run.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.spec}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.spec.automaton;

import org.jspecify.annotations.NullMarked;
