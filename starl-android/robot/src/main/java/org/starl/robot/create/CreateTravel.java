package org.starl.robot.create;

/**
 * How far the robot has come by its own account, since the driver first heard of it; what the wheels
 * slipped is in it. Create 2: from encoder counts. Create 1: from packets 19 and 20, whose rounding
 * to whole mm and degrees adds up, and which that robot is known to tell wrong: a hint.
 *
 * @param forwardMm way of the middle between the wheels; backward is negative
 * @param turnedRad turned, counter-clockwise
 */
public record CreateTravel(double forwardMm, double turnedRad) {

  public static final CreateTravel NONE = new CreateTravel(0, 0);

  /** After the wheels went on by so much. */
  CreateTravel plusWheels(double leftMm, double rightMm, double axleMm) {
    return new CreateTravel(
        forwardMm + (leftMm + rightMm) / 2, turnedRad + (rightMm - leftMm) / axleMm);
  }

  /** After what packets 19 and 20 told. */
  CreateTravel plus(int distanceMm, int angleDegrees) {
    return new CreateTravel(forwardMm + distanceMm, turnedRad + angleDegrees * StrictMath.PI / 180);
  }
}
