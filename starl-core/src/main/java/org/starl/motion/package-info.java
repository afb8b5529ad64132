/**
 * The logic layer's motion (paper, sections 4.1 and 5.1): the motion automaton, a pure step function
 * from pose, bumps and time to wheel speeds, and {@code plat.moat} that drives it.
 *
 * <p>May import: {@code org.starl} value types, {@code org.starl.geometry}, {@code
 * org.starl.platform}.
 */
@NullMarked
package org.starl.motion;

import org.jspecify.annotations.NullMarked;
