package org.starl.robot.file;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * One robot of a deployment.
 *
 * @param line its line in the file
 * @param address of its radio; null if the robot is found by its beacons
 * @param rigidBody its name in the measuring system
 */
public record RobotEntry(
    RobotId id, int line, @Nullable HostPort address, Wheels wheels, String rigidBody) {}
