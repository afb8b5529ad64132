package org.starl.robot.create;

/**
 * The robot's odometry since the first sensor frame; wheel slip counts as travel. Create 2: from
 * encoder counts. Create 1: from packets 19 and 20, which are rounded to whole mm and degrees and known
 * to be wrong on that robot: only a hint.
 *
 * @param forwardMm path of the point between the wheels; backward is negative
 * @param turnedRad turned, counter-clockwise
 */
public record CreateTravel(double forwardMm, double turnedRad) {

  public static final CreateTravel NONE = new CreateTravel(0, 0);

  /** The odometry after these paths of the wheels. */
  CreateTravel plusWheels(double leftMm, double rightMm, double axleMm) {
    return new CreateTravel(
        forwardMm + (leftMm + rightMm) / 2, turnedRad + (rightMm - leftMm) / axleMm);
  }

  /** The odometry after these values of packets 19 and 20. */
  CreateTravel plus(int distanceMm, int angleDegrees) {
    return new CreateTravel(forwardMm + distanceMm, turnedRad + angleDegrees * StrictMath.PI / 180);
  }
}
