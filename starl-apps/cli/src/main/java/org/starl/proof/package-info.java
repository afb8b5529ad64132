/**
 * Runs as obligations of the theorem prover: {@link org.starl.proof.RunTheories} watches a run and
 * writes it as theories for PVS, one for each mutex, registration, agreement and election. That the
 * first state is a start state, that each step is enabled and leads to the next state, that each
 * result is the one recorded: all this is to be proved by rewriting, so that the automata in Java and
 * in PVS cannot part ways unseen.
 *
 * <p>May import: core, primitives, {@code org.starl.sim}.
 */
@NullMarked
package org.starl.proof;

import org.jspecify.annotations.NullMarked;
