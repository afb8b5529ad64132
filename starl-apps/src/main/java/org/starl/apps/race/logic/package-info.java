/**
 * The Race App (paper, section 5.4): all robots drive to the same points in turn; whoever is at a
 * point first has won it and announces that by Broadcast, and all go on to the next one.
 *
 * <p>What holds, whatever the network does and whoever crashes and restarts ({@code
 * org.starl.apps.race.spec} checks it):
 *
 * <ul>
 *   <li>A robot that claims a point is there: its centre within the point's radius, its position's
 *       error bound aside; or, where something stands on the point, as far off as the claim says, after
 *       {@link org.starl.apps.race.logic.Patience}.
 *   <li>A robot replaces the winner that it knows of a point only by a better one: one that was at
 *       the point goes before one that was kept off it, then the earlier arrival by the arrivals' own
 *       clocks, then the order of names. This order is total, hence all who have heard the same claims
 *       agree, however many arrived before they heard of each other.
 * </ul>
 *
 * <p>Progress, while the world behaves: everybody who is up knows that a point is won within 18 s of
 * the first who does, and within 8.5 s more for each nine copies of a message that may all be lost;
 * each point is won; in the end all robots know the same winners. Robots that have crashed for good
 * hold nobody up for more than {@link org.starl.apps.race.logic.RaceApp#TELL_PATIENCE_MS}.
 *
 * <p>Envelope: what Broadcast and motion bear, and crashes with and without restarts.
 *
 * <p>May import: core and primitives only.
 */
@NullMarked
package org.starl.apps.race.logic;

import org.jspecify.annotations.NullMarked;
