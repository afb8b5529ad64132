/**
 * The simulated platform: one facade that builds a run from settings, and what it takes and gives.
 * The parts lie in sub-packages, none of which knows the insides of another.
 *
 * <p>May import: {@code org.starl} core, and the sub-packages of {@code org.starl.sim} that the
 * facade joins. Of this package the sub-packages that watch or repeat a run ({@code check}, {@code
 * export}, {@code record}, {@code replay}, {@code view}) import its observers, settings and results; the others import nothing.
 */
@NullMarked
package org.starl.sim;

import org.jspecify.annotations.NullMarked;
