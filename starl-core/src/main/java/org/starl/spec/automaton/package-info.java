/**
 * Code tied to proof. A primitive is proved safe in PVS as an automaton: its states, which actions a
 * state enables, which state an action leads to. {@link org.starl.spec.automaton.Automaton} is the
 * same automaton in Java, under the same names, so that it can be read beside its theory in {@code
 * pvs/}. {@link org.starl.spec.automaton.Replay} takes a run of the real implementation through it:
 * a map from trace events to actions, one for each primitive, says what the run did, and each of its
 * actions must be enabled where the run stands, each result that the trace records must be the
 * automaton's. What is proved of all runs of the automaton then holds of this run.
 *
 * <p>May import: {@code org.starl} ids, {@code org.starl.spec}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.spec.automaton;

import org.jspecify.annotations.NullMarked;
