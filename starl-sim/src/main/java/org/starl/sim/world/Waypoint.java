package org.starl.sim.world;

import java.util.OptionalDouble;
import org.starl.geometry.Angles;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;

/**
 * A line {@code WAY} or {@code SENSE} of a waypoint file.
 *
 * @param angle the angle column, unconverted: degrees in most files, a robot's number or a 24-bit
 *     colour in some
 * @param radiusMm the arrival tolerance, if the file has one
 * @param line its number in the file, from 1
 */
public record Waypoint(
    String name, double xMm, double yMm, double angle, OptionalDouble radiusMm, int line) {

  /** The waypoint as a pose, for files whose angle column is in degrees. */
  public ItemPosition position() {
    double headingRad = Angles.normalize(Angles.fromDegrees(angle));
    return new ItemPosition(name, new Pose(xMm, yMm, headingRad));
  }
}
