/**
 * A workload for each primitive, as {@code starl run mutex} or {@code starl campaign mutex} runs it:
 * robots that use the primitive in rounds, with all of its monitors on. {@link
 * org.starl.workload.PrimitiveWorkloads#ALL} lists them.
 *
 * <p>A robot ends when it has done all its rounds; the last ones begin when the faults of the run are
 * over. So a run that does not finish is one in which the primitive made no progress although the
 * world behaved. What a primitive tells ({@code failed}) is no violation: the round is tried again.
 *
 * <p>{@link org.starl.workload.Client} is what all of these robots do, {@link
 * org.starl.workload.PrimitiveDemo} what all of these runs have in common.
 *
 * <p>May import: all other modules; of this one {@code org.starl.apps}, what the command line needs
 * to know of an app.
 */
@NullMarked
package org.starl.workload;

import org.jspecify.annotations.NullMarked;
