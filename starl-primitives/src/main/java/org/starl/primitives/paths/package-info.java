/**
 * Path planning, for one robot and for several (paper, sections 4 and 5.4).
 *
 * <h2>One robot</h2>
 *
 * <p>{@link org.starl.primitives.paths.PathPlanner} is the interface; {@link
 * org.starl.primitives.paths.RrtPlanner} grows a random tree and smooths the path, as the original
 * StarL did; {@link org.starl.primitives.paths.OptimalPlanner} finds a shortest path or proves that
 * there is none. Planners are pure and take long: they run outside the strand, {@code
 * gvh.plat.compute(() -> planner.plan(task))}.
 *
 * <p>(a) <b>Safety.</b> A disc of the body's radius that follows the path stays farther than the
 * clearance from every obstacle, and inside the bounds. (b) <b>Progress.</b> The optimal planner
 * finds a path whenever there is one for a margin that is larger by 4 mm and half a per cent, and
 * returns {@code NoPath} otherwise; the random one may return {@code GaveUp}. An end that is not
 * free gives {@code Blocked}: a robot that touches an obstacle must back off before it plans. (c)
 * <b>Assumptions.</b> Obstacles do not move while the path is driven, and all are on the map. The
 * caller's clearance must cover the robot's deviation from the path.
 *
 * <p>Determinism: JTS widens and unites the obstacles, and the result is rounded to whole mm; the
 * rest is exact integer arithmetic and square roots. Equal tasks give equal plans on every JVM.
 *
 * <h2>Several: reach tubes</h2>
 *
 * <p>{@link org.starl.primitives.paths.DistributedPathPlanning} drives each robot to its goals
 * inside its own <em>tube</em>: all points that its body may occupy while it follows its path,
 * including position error and tracking error. Each robot plans around the tubes that it knows,
 * requests a tube from all robots, drives in it when a majority has consented, and releases it part
 * by part. There is no central robot. {@link org.starl.primitives.paths.TubesSpec} is this contract
 * as a monitor.
 *
 * <ul>
 *   <li>(a) <b>Safety.</b> {@code Tubes}: no two robots hold tubes that meet. {@code Inside}: the
 *       true body of a robot that follows its tube is inside it. Hence no two of these bodies
 *       touch.
 *   <li>(b) <b>Progress.</b> A claim that meets no other tube is granted after 2 delta and two
 *       writes to stable storage, if a majority is running and in reach; delta is the time within
 *       which a repeated message arrives. Claims that do not meet never wait for each other. Claims
 *       that meet may refuse each other; growing random pauses make long repetition unlikely.
 *       {@code Told}: every {@code goTo} is DONE or FAIL when its deadline and the limits of its
 *       motions have passed, with the reason in {@code failure()}. If two robots block each other's
 *       only path, both fail.
 *   <li>(c) <b>Assumptions.</b> {@code Tubes} holds under every loss, delay, duplication,
 *       reordering and partition, and under any crashes and restarts, if stable storage keeps all
 *       flushed data and messages are not forged. {@code Inside} depends on the bound of the
 *       position error, on {@code do_move(t, A)} with each part's border as A, and on a chassis
 *       that stops when its program does. The group is fixed: all robots that move on the floor.
 *       Everything else on the floor is an obstacle on the map.
 * </ul>
 *
 * <p><b>Algorithm.</b> Two majorities always have a common voter. A voter stores each consent on
 * stable storage before it sends it, and consents to no tube that meets a noted one ({@code
 * TubeVoter}; after Thomas, "A majority consensus approach to concurrency control", ACM TODS 4(2),
 * 1979). If two tubes that meet were both granted, some voter would have consented to both. A
 * robot's messages contain all its held and wanted tubes, with a version number ({@code
 * TubeClaimant}). A newer version replaces an older one, so losses, duplicates and reordering do no
 * harm. A robot stores a release before it sends it: after a restart it holds the tubes that the
 * others believe it to hold, or fewer.
 *
 * <p>The discs of two robots at their starts must not touch: the simulator draws starts accordingly,
 * if tubes are created before the first fix, and refuses given ones that are nearer.
 *
 * <p>A robot first claims the disc at its place; no robot moves before all have done so ({@code
 * unplaced()} lists the missing ones). A crashed robot keeps its tubes, and the others plan around
 * them or fail. After a restart it still holds its tubes, and continues from there.
 *
 * <p>If a robot stands so close to another robot's tube that rounding leaves the planner no path,
 * its path begins at a free point nearby ({@code Departure}): two robots that stopped side by side
 * may both leave.
 *
 * <p>May import: core, {@code org.starl.primitives}, JTS.
 */
@NullMarked
package org.starl.primitives.paths;

import org.jspecify.annotations.NullMarked;
