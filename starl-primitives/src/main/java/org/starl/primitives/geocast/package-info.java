/**
 * Geocast and Broadcast (paper, section 4.2): a message to all other robots in an area A, within an
 * interval of length d. {@link org.starl.primitives.geocast.Geocast#do_geocast} and {@link
 * org.starl.primitives.geocast.Broadcast#BCast} start it at t0.
 *
 * <p>A copy carries its origin, number, area, t0 and t0 + d. The origin repeats it until t0 + d, or
 * until every other robot of the deployment has acknowledged. A receiver decides by its own
 * position when a copy comes: it delivers if it is in A for certain and the interval is not over,
 * and drops the copy otherwise; the next copy is another chance. "Where" is the centre of the
 * robot's body. The origin itself does not deliver: the paper says "all other processes/robots".
 *
 * <p>(a) <b>Safety</b>, for a message of [t0, t0 + d]:
 *
 * <ul>
 *   <li>{@code exclusion}: a robot whose true position is outside A throughout does not deliver it.
 *       More than that, who delivers is in A at that moment.
 *   <li>{@code deadline}: nobody delivers it after t0 + d.
 *   <li>{@code once}: no robot delivers it twice, unless it restarts in between.
 * </ul>
 *
 * <p>A robot that enters or leaves A in the interval may deliver it or not. {@code Gcastflag} is
 * true when every geocast of this robot is complete: from t0 + d at the latest, and from then on
 * nobody delivers it any more. It may be true earlier, once all have acknowledged.
 *
 * <p>(b) <b>Progress</b>: {@code inclusion}: a robot that is in A throughout, farther from its
 * border than its own position may be wrong, delivers the message if one copy reaches it in time.
 * Copies follow each other after 100 ms at first and 1 s at most ({@link
 * org.starl.primitives.geocast.GeocastSettings}). Who has delivered for certain is in {@link
 * org.starl.primitives.geocast.GeocastReceipt#acknowledgedBy}; of others nothing is known.
 *
 * <p>{@link org.starl.primitives.geocast.GeocastConformance} takes each run through the automaton
 * of which safety is proved.
 *
 * <p>(c) <b>Envelope and assumptions.</b> Any loss, delay, duplication, reordering, partition,
 * crash and restart. Space and time cannot be kept blindly, so two bounds must hold, and shrink A
 * and d:
 *
 * <ul>
 *   <li>Positions: a robot's true position lies within {@code gvh.gps.errorMm()} of the one that it
 *       believes; that bound includes the age of its last fix and its speed. A shrinks by it.
 *   <li>Clocks: no two robots' clocks ever differ by more than {@code clockSkewNs}, 0 by default.
 *       The deadline is a time on the origin's clock, and receivers stop that much before it. A
 *       copy from farther in the future than that proves the clocks wrong and is dropped. Counting
 *       the age of a copy hop by hop instead would need no clocks, but a radio that delays a
 *       datagram without bound does not tell by how much.
 * </ul>
 *
 * <p>Copies are single datagrams in radio reach of the origin; nobody passes them on.
 *
 * <p>May import: core, {@code org.starl.primitives}.
 */
@NullMarked
package org.starl.primitives.geocast;

import org.jspecify.annotations.NullMarked;
