package org.starl.robot.file;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.robot.udp.PublicRobotKey;

/**
 * One robot of a deployment.
 *
 * @param line its line in the file
 * @param address of its radio; null if the robot is found by its beacons
 * @param rigidBody its name in the measuring system
 * @param publicKeys its own keys, the newest first; none if robots have no keys of their own
 * @param objects its sensor for objects that are no robots; null for none
 */
public record RobotEntry(
    RobotId id,
    int line,
    @Nullable HostPort address,
    Wheels wheels,
    String rigidBody,
    List<PublicRobotKey> publicKeys,
    @Nullable ObjectSource objects) {

  public RobotEntry {
    publicKeys = List.copyOf(publicKeys);
  }
}
