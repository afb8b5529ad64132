/**
 * A robot's radio over UDP, and its stable storage in files: the twins of the simulated ones, held
 * to the same contract tests. Each has one thread of its own, below the robot's strand, and calls
 * back on the strand only.
 *
 * <p>{@link org.starl.robot.udp.Discovery} says by beacons over the same socket who is where, and who
 * has fallen silent. The deployment's key, in a {@link org.starl.robot.udp.KeyFile}, signs beacons;
 * messages are sealed with it above the radio.
 *
 * <p>What the network and the disk do wrong is counted or told, never thrown through an app.
 *
 * <p>May import: the JDK as far as Android API 26 has it, {@code org.starl} ids, {@code
 * org.starl.platform}, {@code org.starl.random}.
 */
@NullMarked
package org.starl.robot.udp;

import org.jspecify.annotations.NullMarked;
