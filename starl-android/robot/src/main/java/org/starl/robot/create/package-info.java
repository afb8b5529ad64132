/**
 * The iRobot Create over its Open Interface: a driver that is a robot's {@link
 * org.starl.platform.Chassis}, and the robot itself, simulated byte by byte, as its peer.
 *
 * <p>Begin with {@link org.starl.robot.create.CreateChassis}; hardware in the loop begins with
 * {@link org.starl.robot.create.CreateHost}. Both stand at an end of a {@link
 * org.starl.robot.create.ByteLink}: a serial port, a Bluetooth or TCP socket, a pseudo terminal.
 *
 * <p>Contract of the driver: (a) the wheels turn only while the link lives, the sensors are heard,
 * the robot is in the mode that is wanted, the program repeats its commands, and fixes come; a bump,
 * a cliff or a wheel that drops stops them before the robot's strand hears of it, and an emergency
 * stop until it is taken back. What the wheels were told is told again every
 * 50 ms: what noise did to one command does not last.
 * (b) whatever is lost (link, mode, stream) is told, and taken up again by itself. What cannot be
 * promised: a Create goes on with its last command when its link is cut, for it has no watchdog of
 * its own; in safe mode it stops by itself at cliffs and when it is lifted.
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
