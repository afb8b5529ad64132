/**
 * A workload for each primitive, for {@code starl run mutex} or {@code starl campaign mutex}:
 * robots that use the primitive in rounds, checked by all of its monitors. {@link
 * org.starl.workload.PrimitiveWorkloads#ALL} lists them.
 *
 * <p>A robot ends when it has done all its rounds; the last three begin when the faults of the run
 * are over. So an unfinished run is one in which the primitive made no progress without faults. A
 * failure that a primitive reports ({@code failed}) is no violation: the request is repeated.
 *
 * <p>{@link org.starl.workload.Client} is the program of all these robots, {@link
 * org.starl.workload.Setup} adds them to a run and has its time bounds.
 *
 * <p>May import: all other modules; of this one {@code org.starl.apps}, the types
 * of an app.
 */
@NullMarked
package org.starl.workload;

import org.jspecify.annotations.NullMarked;
