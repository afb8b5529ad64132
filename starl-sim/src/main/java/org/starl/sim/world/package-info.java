/**
 * The simulated floor: bodies, walls and bumps; the ports of each robot to it (chassis,
 * positioning, stable storage); and the readers of waypoint, obstacle and grid map files.
 *
 * <p>Contract: a body is a disc. Between two changes of its motion it drives with constant forward
 * and turning speed, and its pose follows in closed form ({@link org.starl.geometry.Kinematics}).
 * Bodies are solid: no two overlap, and none overlaps a wall. They touch at gaps up to {@link
 * org.starl.sim.world.World#TOUCH_MM}. A body whose command presses against a contact turns but
 * does not advance; it is free again when its command leads along or away, or when the gap exceeds
 * {@link org.starl.sim.world.World#CLEAR_MM}. A body is never pushed. The cost of a body is
 * proportional to the path that it drives, times the number of bodies within about a metre; a body
 * at rest costs nothing.
 *
 * <p>May import: {@code org.starl} core, {@code org.starl.input}.
 */
@NullMarked
package org.starl.sim.world;

import org.jspecify.annotations.NullMarked;
