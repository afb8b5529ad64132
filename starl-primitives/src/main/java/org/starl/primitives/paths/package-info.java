/**
 * Path planning (paper, sections 4 and 5.4): a way for one body around the obstacles that it knows.
 *
 * <p>{@link org.starl.primitives.paths.PathPlanner} is the interface; {@link
 * org.starl.primitives.paths.RrtPlanner} grows a random tree and smooths what it finds, as the
 * original StarL did; {@link org.starl.primitives.paths.OptimalPlanner} finds a shortest path or
 * proves that there is none. Planners are pure and take long: they run off the strand, {@code
 * gvh.plat.compute(() -> planner.plan(task))}.
 *
 * <p>(a) <b>Safety.</b> A disc of the body's radius that follows the path stays farther than the
 * clearance from every obstacle, and inside the bounds. (b) <b>Progress.</b> The optimal planner finds
 * a path whenever there is one for a margin that is larger by 2.5 mm and half a per cent, and says
 * {@code NoPath} otherwise; the random one may give up, and says so. Ends that are not free are told,
 * {@code Blocked}. (c) <b>Assumptions.</b> Obstacles stand still while the path is driven, and are all
 * on the map. How far a robot strays from its path is the caller's clearance to choose.
 *
 * <p>Determinism: obstacles are widened and joined by JTS, and rounded to whole millimetres; all that
 * decides after that is exact integer arithmetic, or square roots. Equal tasks give equal plans on
 * every JVM.
 *
 * <p>May import: core, {@code org.starl.primitives}, JTS.
 */
@NullMarked
package org.starl.primitives.paths;

import org.jspecify.annotations.NullMarked;
