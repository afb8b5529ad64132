package org.starl.robot.optitrack;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;

/**
 * One body in a feed's last message.
 *
 * @param name of the rigid body, or of the robot
 * @param id the rigid body's number; -1 where a feed has none
 * @param fix where it was; null if the cameras have lost it
 */
public record TrackedBody(String name, int id, @Nullable Fix fix) {}
