/**
 * Runs as proof obligations: {@link org.starl.proof.RunTheories} watches a run and writes it as PVS
 * theories, one for each mutex, registration, agreement and election. The obligations are that the
 * first state is a start state, that each step is enabled and leads to the next state, and that
 * each result is the recorded one. PVS proves them by rewriting, so that the automata in Java and
 * in PVS cannot diverge unnoticed.
 *
 * <p>May import: core, primitives, {@code org.starl.sim}.
 */
@NullMarked
package org.starl.proof;

import org.jspecify.annotations.NullMarked;
