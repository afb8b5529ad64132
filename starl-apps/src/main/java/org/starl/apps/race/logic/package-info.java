/**
 * The Race App (paper, section 5.4): all robots drive to the same points in turn. The first robot
 * at a point has won it and announces that by Broadcast; then all go on to the next point.
 *
 * <p>Safety, under all faults of the network and all crashes and restarts ({@code
 * org.starl.apps.race.spec} checks it):
 *
 * <ul>
 *   <li>A robot that claims a point is there: its centre is within the point's radius, plus its
 *       position's error bound; or, where something stands on the point, as far off as the claim
 *       says and {@link org.starl.apps.race.logic.Patience} allows.
 *   <li>A robot replaces the winner that it knows of a point only by a better one: a robot that was
 *       at the point comes before one that was kept off it, then the earlier arrival by the
 *       winners' own clocks, then the order of names. This order is total, so all robots that have
 *       heard the same claims agree, however many robots arrived before they heard of each other.
 * </ul>
 *
 * <p>Progress, while the world behaves: each point is won; all robots that are up know it within 18
 * s of the first that does, plus 8.5 s for each nine copies of a message that may all be lost; in
 * the end all robots know the same winners. A robot that has crashed for ever holds up the others
 * for at most {@link org.starl.apps.race.logic.RaceApp#TELL_PATIENCE_MS}.
 *
 * <p>Envelope: all that Broadcast and motion tolerate, and crashes with and without restarts.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.race.logic;

import org.jspecify.annotations.NullMarked;
