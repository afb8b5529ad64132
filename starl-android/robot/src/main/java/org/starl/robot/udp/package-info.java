/**
 * A robot's radio over UDP and its stable storage in files: the counterparts of the simulated ones,
 * with the same contract tests. Each has one thread of its own, below the robot's strand, and calls
 * back on the strand only.
 *
 * <p>{@link org.starl.robot.udp.Discovery} finds robots by beacons over the same socket, proves and
 * checks that they are of the present start of a robot's program, opens sessions, and suspects silent
 * robots. Keys are in a {@link org.starl.robot.udp.RobotKey}'s or {@link
 * org.starl.robot.udp.KeyFile}'s file; messages are sealed above the radio (docs/security.md).
 *
 * <p>Errors of the network and the disk are counted or reported, never thrown through an app.
 *
 * <p>May import: the JDK as far as Android API 26 has it, {@code org.starl} ids, {@code
 * org.starl.platform}, {@code org.starl.random}, {@code org.starl.session}.
 */
@NullMarked
package org.starl.robot.udp;

import org.jspecify.annotations.NullMarked;
