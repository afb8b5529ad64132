/**
 * The specification of a race, as monitors over the trace: the winner of a point is at it, all
 * robots agree on the winners, and the race goes on.
 *
 * <p>May import: core, primitives, {@code logic} beside it.
 */
@NullMarked
package org.starl.apps.race.spec;

import org.jspecify.annotations.NullMarked;
