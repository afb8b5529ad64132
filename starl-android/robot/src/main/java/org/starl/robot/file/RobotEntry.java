package org.starl.robot.file;

import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * One robot of a deployment.
 *
 * @param line of the file
 * @param address where its radio listens; null for one that is found by its beacons
 * @param rigidBody what the measuring system calls it
 */
public record RobotEntry(
    RobotId id, int line, @Nullable HostPort address, Wheels wheels, String rigidBody) {}
