/**
 * One real robot, put together as a deployment file says: strand, radio, storage, positions and wheels
 * under its app. {@link org.starl.robot.DeployedRobot} is the whole; what a phone and a Linux
 * board do not have alike (how bytes get to a Create) comes in from outside, as a {@link
 * org.starl.robot.Wheelbase}.
 *
 * <p>Contract: whatever ends a robot, its wheels are stopped first. What the network, the measuring
 * system or the wheels do wrong is logged and counted; what stops the robot for good is told to its
 * {@link org.starl.robot.DeployedRobot.Host}.
 *
 * <p>May import: the JDK as far as Android API 26 has it, core, {@code org.starl.robot}.
 */
@NullMarked
package org.starl.robot;

import org.jspecify.annotations.NullMarked;
