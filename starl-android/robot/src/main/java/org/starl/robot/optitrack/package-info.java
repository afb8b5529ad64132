/**
 * Positions from outside, measured by cameras (paper, section 5.1): a client of OptiTrack's NatNet
 * streams, a small NatNet server for tests and simulation, and a feed of JSON lines for other measuring
 * systems. {@link org.starl.robot.optitrack.NatNetClient} and {@link
 * org.starl.robot.optitrack.JsonFeed} are the two {@link org.starl.robot.optitrack.PoseFeed}s; each
 * gives a {@link org.starl.platform.Positioning} for a robot, on that robot's strand.
 *
 * <p>Contract: millimetres, radians counter-clockwise from the x axis, times of fixes on the clock
 * that the feed was given. The time of a fix is that of its measurement, not of its arrival, and its
 * error bound includes the uncertainty of that time. A body that the cameras have lost gives no fix. Faulty datagrams are counted, dropped and logged once for each kind of fault; no bytes make a
 * feed fail or allocate more than a multiple of their length. NatNet is not
 * authenticated: any host that can send from the server's address can send false positions. Those that
 * contradict the true ones, or a robot's odometry, stop it. JSON lines are authenticated if the feed has a key.
 *
 * <p>May import: the JDK as far as Android API 26 has it, {@code org.starl} ids, {@code
 * org.starl.geometry}, {@code org.starl.platform}.
 */
@NullMarked
package org.starl.robot.optitrack;

import org.jspecify.annotations.NullMarked;
