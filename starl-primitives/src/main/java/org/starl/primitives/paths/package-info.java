/**
 * Path planning, for one robot and for several (paper, sections 4 and 5.4).
 *
 * <h2>One robot</h2>
 *
 * <p>{@link org.starl.primitives.paths.PathPlanner} is the interface; {@link
 * org.starl.primitives.paths.RrtPlanner} grows a random tree and smooths what it finds, as the
 * original StarL did; {@link org.starl.primitives.paths.OptimalPlanner} finds a shortest path or
 * proves that there is none. Planners are pure and take long: they run off the strand, {@code
 * gvh.plat.compute(() -> planner.plan(task))}.
 *
 * <p>(a) <b>Safety.</b> A disc of the body's radius that follows the path stays farther than the
 * clearance from every obstacle, and inside the bounds. (b) <b>Progress.</b> The optimal planner finds
 * a path whenever there is one for a margin that is larger by 4 mm and half a per cent, and says
 * {@code NoPath} otherwise; the random one may give up, and says so. Ends that are not free are told,
 * {@code Blocked}: a robot that touches an obstacle backs off before it plans. (c)
 * <b>Assumptions.</b> Obstacles stand still while the path is driven, and are all on the map. How far
 * a robot strays from its path is the caller's clearance to choose.
 *
 * <p>Determinism: obstacles are widened and joined by JTS, and rounded to whole millimetres; all that
 * decides after that is exact integer arithmetic, or square roots. Equal tasks give equal plans on
 * every JVM.
 *
 * <h2>Several: reach tubes</h2>
 *
 * <p>{@link org.starl.primitives.paths.DistributedPathPlanning} brings each robot to its goals inside
 * a <em>tube</em> of its own: all places that its body may occupy while it follows its path, as wide
 * as body, position error and tracking error together. Each robot plans around the tubes that it
 * knows of, asks everybody for its own, drives in it when a majority has consented, and gives it back
 * part by part. There is no central robot. {@link org.starl.primitives.paths.TubesSpec} is this
 * contract as a monitor.
 *
 * <ul>
 *   <li>(a) <b>Safety.</b> {@code Tubes}: no two robots hold tubes that meet. {@code Inside}: the true
 *       body of a robot that follows its tube is inside it. Hence no two of them touch.
 *   <li>(b) <b>Progress.</b> A claim that meets nobody's tube is granted after 2 delta and two writes
 *       to stable storage, delta being the time within which a repeated message arrives, as long as a
 *       majority is up and in reach; claims that do not meet never wait for each other. Claims that
 *       meet may refuse each other; random pauses that grow make it unlikely to last. {@code Told}:
 *       every {@code goTo} is DONE or FAIL at the latest when its deadline and the motions' own
 *       limits have passed, with the reason in {@code failure()}. Nothing resolves two robots that
 *       stand in each other's only way: both are told.
 *   <li>(c) <b>Assumptions.</b> {@code Tubes} holds under every loss, delay, duplication, reordering
 *       and partition, and whoever crashes and restarts, provided that stable storage keeps what it
 *       has flushed and messages are not forged. {@code Inside} rests on the position's error bound
 *       and on {@code do_move(t, A)}, each part's border being A; and on a chassis that stops when
 *       its program does. The group is fixed: all that move on the floor. What else stands there is
 *       on the map as an obstacle.
 * </ul>
 *
 * <p><b>How.</b> Majorities meet: a voter notes what it consents to, on stable storage, before it says
 * so, and consents to nothing that meets a note ({@code TubeVoter}; after Thomas, "A majority
 * consensus approach to concurrency control", ACM TODS 4(2), 1979). If two tubes that meet were both
 * granted, some voter would have consented to both. A robot's word is complete in itself and
 * numbered: what it holds and what it wants ({@code TubeClaimant}); a newer one replaces an older
 * one, so losses, doubles and overtaking do no harm. A robot writes what it gives back before it says
 * so: after a restart it holds what the others believe that it holds, or less.
 *
 * <p>The first thing that a robot claims is the disc where it stands; nobody moves before everybody
 * has ({@code unplaced()} says who is missing). A crashed robot keeps its tube: the others plan around
 * it, or are told. When it restarts it holds what it held, and goes on from there.
 *
 * <p>Whoever stands so close to another one's tube that a planner, which rounds, sees no way from
 * there, begins its way a little beside ({@code Departure}): two that stopped side by side may both
 * leave.
 *
 * <p>May import: core, {@code org.starl.primitives}, JTS.
 */
@NullMarked
package org.starl.primitives.paths;

import org.jspecify.annotations.NullMarked;
