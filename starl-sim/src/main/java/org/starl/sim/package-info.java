/**
 * The simulated platform: a facade that builds a run from settings, with its inputs and results.
 * The parts are in sub-packages, which do not depend on each other's internals.
 *
 * <p>May import: {@code org.starl} core, and the sub-packages of {@code org.starl.sim} that the
 * facade connects. The sub-packages that observe or repeat a run ({@code check}, {@code export},
 * {@code record}, {@code replay}, {@code view}) import the observers, settings and results of this
 * package; the others do not.
 */
@NullMarked
package org.starl.sim;

import org.jspecify.annotations.NullMarked;
