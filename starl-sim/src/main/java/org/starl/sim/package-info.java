/**
 * The simulated platform: one facade that builds a run from settings, and what it takes and gives.
 * The parts lie in sub-packages, none of which knows the insides of another.
 *
 * <p>May import: {@code org.starl} core, and the sub-packages of {@code org.starl.sim} that the
 * facade joins. Sub-packages import nothing of this package but {@link org.starl.sim.BadInput},
 * {@link org.starl.sim.Quantities} and, where they are built from a run, its settings and results.
 */
@NullMarked
package org.starl.sim;

import org.jspecify.annotations.NullMarked;
