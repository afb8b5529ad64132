/**
 * One real robot as a deployment file describes it: strand, radio, storage, positions and wheels under
 * its app. {@link org.starl.robot.DeployedRobot} is the whole; the part that differs between a
 * phone and a Linux board (the link to a Create) is passed in as a {@link
 * org.starl.robot.create.Wheelbase}.
 *
 * <p>Contract: whatever ends a robot, its wheels are stopped first. Errors of the network, the
 * measuring system or the wheels are logged and counted; an error that ends the robot goes to its
 * {@link org.starl.robot.DeployedRobot.Host}.
 *
 * <p>May import: the JDK as far as Android API 26 has it, core, {@code org.starl.robot}.
 */
@NullMarked
package org.starl.robot;

import org.jspecify.annotations.NullMarked;
