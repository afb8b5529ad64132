/**
 * The iRobot Create over its Open Interface: a driver that is a robot's {@link
 * org.starl.platform.Chassis}, and the robot itself, simulated byte by byte, as its peer.
 *
 * <p>Start with {@link org.starl.robot.create.CreateChassis}; for hardware in the loop start with
 * {@link org.starl.robot.create.CreateHost}. Each is at one end of a
 * {@link org.starl.robot.create.ByteLink}: a serial port, a Bluetooth or TCP socket, a pseudo terminal.
 *
 * <p>Contract of the driver: (a) the wheels turn only while the link works, sensor frames arrive,
 * the robot is in the wanted mode, the program repeats its commands, and fixes arrive. A bump, a
 * cliff or a wheel drop stops them before the robot's strand is informed; an emergency stop holds
 * them until it is released. The wheel speeds are sent again every 50 ms, so that a command changed
 * by noise does not last. (b) A lost link, mode or stream is reported and restored automatically.
 * Not promised: a Create continues its last command when its link is cut, because it has no watchdog
 * of its own; in safe mode it stops by itself at cliffs and when it is lifted.
 *
 * <p>Envelope: any bytes from the link, any cut of it at any time, calls from any thread.
 *
 * <p>Facts are of "iRobot Create Open Interface (OI) Specification" (2006) and "iRobot Create 2 Open
 * Interface (OI) Specification based on the iRobot Roomba 600" (2016), called Create 1 and Create 2
 * here. Lengths are mm, speeds mm/s, angles rad, counter-clockwise.
 *
 * <p>May import: the JDK as far as Android API 26 has it, {@code org.starl.geometry}, {@code
 * org.starl.motion}, {@code org.starl.platform}.
 */
@NullMarked
package org.starl.robot.create;

import org.jspecify.annotations.NullMarked;
