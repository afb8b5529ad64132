package org.starl.robot.optitrack;

/** An axis of a rigid body, in its own coordinates. */
public enum BodyAxis {
  PLUS_X(1, 0, 0),
  MINUS_X(-1, 0, 0),
  PLUS_Y(0, 1, 0),
  MINUS_Y(0, -1, 0),
  PLUS_Z(0, 0, 1),
  MINUS_Z(0, 0, -1);

  final double x;
  final double y;
  final double z;

  BodyAxis(double x, double y, double z) {
    this.x = x;
    this.y = y;
    this.z = z;
  }
}
