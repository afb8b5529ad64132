/**
 * Geocast and Broadcast (paper, section 4.2): a message to all other robots in an area A, within an
 * interval of length d. {@link org.starl.primitives.geocast.Geocast#do_geocast} and {@link
 * org.starl.primitives.geocast.Broadcast#BCast} start it at t0.
 *
 * <p>A copy contains its origin, number, area, t0 and t0 + d. The origin repeats it until t0 + d,
 * or until every other robot of the deployment has acknowledged. When a copy arrives, the receiver
 * decides by its own position: it delivers if it is certainly in A and the interval is not over,
 * and drops the copy otherwise; a later copy may still be delivered. A robot's position is the
 * centre of its body. The origin itself does not deliver: the paper says "all other
 * processes/robots".
 *
 * <p>(a) <b>Safety</b>, for a message of [t0, t0 + d]:
 *
 * <ul>
 *   <li>{@code exclusion}: a robot whose true position is always outside A does not deliver it.
 *       Moreover, a robot that delivers is in A at that moment.
 *   <li>{@code deadline}: no robot delivers it after t0 + d.
 *   <li>{@code once}: no robot delivers it twice, unless it restarts in between.
 *   <li>{@code acknowledged}: a robot acknowledges it only after it has delivered it.
 * </ul>
 *
 * <p>A robot that enters or leaves A in the interval may deliver it or not. {@code Gcastflag} is
 * true when every geocast of this robot is complete: at the latest from t0 + d, when no robot
 * delivers it any more, or earlier, once all robots have acknowledged.
 *
 * <p>(b) <b>Progress</b>: {@code inclusion}: a robot that is always in A, farther from its border
 * than its position error, delivers the message if one copy reaches it in time. The time between
 * copies is 100 ms at first and at most 1 s ({@link org.starl.primitives.geocast.GeocastSettings}).
 * {@link org.starl.primitives.geocast.GeocastReceipt#acknowledgedBy} contains the robots that have
 * certainly delivered; nothing is known about others.
 *
 * <p>{@link org.starl.primitives.geocast.GeocastConformance} replays each run on the automaton
 * whose safety is proved.
 *
 * <p>(c) <b>Envelope and assumptions.</b> Any loss, delay, duplication, reordering, partition,
 * crash and restart. Positions and clocks have errors, so two bounds must hold; they reduce A and
 * d:
 *
 * <ul>
 *   <li>Positions: a robot's true position is within {@code gvh.gps.errorMm()} of its estimated
 *       one; that bound includes the age of its last fix and its speed. A shrinks by it.
 *   <li>Clocks: no two robots' clocks ever differ by more than {@code clockSkewNs}, 0 by default.
 *       The deadline is a time on the origin's clock, and receivers stop that much before it. A
 *       copy from farther in the future proves that the clocks differ by more, and is dropped.
 *       Counting the age of a copy hop by hop instead would need no common clock, but a radio with
 *       unbounded delays does not report the delay of a datagram.
 * </ul>
 *
 * <p>Copies are single datagrams in radio reach of the origin; robots do not forward them.
 *
 * <p>May import: core, {@code org.starl.primitives}.
 */
@NullMarked
package org.starl.primitives.geocast;

import org.jspecify.annotations.NullMarked;
