package org.starl.body;

/**
 * What a differential drive shall do: a forward speed and a turning speed, counter-clockwise
 * positive. Any two wheel speeds are one such pair.
 */
public record WheelCommand(double linearMmPerS, double angularRadPerS) {

  public static final WheelCommand STOP = new WheelCommand(0, 0);

  public WheelCommand {
    if (!Double.isFinite(linearMmPerS) || !Double.isFinite(angularRadPerS)) {
      throw new IllegalArgumentException("not finite: " + linearMmPerS + ", " + angularRadPerS);
    }
  }

  /** Speed of the left wheel in mm/s, for wheels {@code trackMm} apart. */
  public double leftMmPerS(double trackMm) {
    return linearMmPerS - angularRadPerS * trackMm / 2;
  }

  /** Speed of the right wheel in mm/s, for wheels {@code trackMm} apart. */
  public double rightMmPerS(double trackMm) {
    return linearMmPerS + angularRadPerS * trackMm / 2;
  }

  public boolean isStop() {
    return linearMmPerS == 0 && angularRadPerS == 0;
  }
}
