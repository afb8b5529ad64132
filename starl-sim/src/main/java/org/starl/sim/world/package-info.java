/**
 * The simulated floor and what stands and drives on it: bodies, walls, bumps, and each robot's own
 * ports into it (chassis, positioning, stable storage); and the readers of waypoint and
 * obstacle files and of grid maps.
 *
 * <p>Contract: a body is a disc. Between two changes of its motion it drives with constant forward
 * and turning speed, and its pose follows in closed form ({@link org.starl.geometry.Kinematics}).
 * Bodies are solid: no two ever overlap, and none enters a wall. They touch from a gap of {@link
 * org.starl.sim.world.World#TOUCH_MM} on; a body whose command presses against what it touches turns
 * but does not advance, and is free again as soon as its command leads along or away, or the other
 * one is more than {@link org.starl.sim.world.World#CLEAR_MM} off. Nobody is pushed. A body's cost is
 * in proportion to the way that it drives, times the bodies within about a metre; a standing body
 * costs nothing.
 *
 * <p>May import: {@code org.starl} core, {@code org.starl.input}.
 */
@NullMarked
package org.starl.sim.world;

import org.jspecify.annotations.NullMarked;
