/**
 * The ports between one robot's portable layers and the platform below (paper, Figure 1 and section
 * 5): small interfaces that the simulator and the real platform implement, collected in {@link
 * org.starl.platform.Platform}.
 *
 * <p>Contract, the same on both sides: every callback runs on the robot's {@link
 * org.starl.platform.Strand}, one at a time; no port calls back from inside a call to it. Time is
 * in nanoseconds since the start of the run, distances in millimetres, angles in radians,
 * counter-clockwise from the x axis.
 *
 * <p>May import: {@code org.starl.body}, {@code org.starl.geometry}, {@code org.starl.id}, {@code
 * org.starl.random}, {@code org.starl.session}, {@code org.starl.trace}.
 */
@NullMarked
package org.starl.platform;

import org.jspecify.annotations.NullMarked;
