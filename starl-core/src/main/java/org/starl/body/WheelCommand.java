package org.starl.body;

/**
 * A command for a differential drive: forward speed and turning speed, counter-clockwise positive.
 * Every pair of wheel speeds corresponds to one command.
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

  /** The absolute speed of the faster wheel, with a distance of {@code trackMm} between the wheels. */
  public double fastestMmPerS(double trackMm) {
    return Math.max(Math.abs(leftMmPerS(trackMm)), Math.abs(rightMmPerS(trackMm)));
  }

  public boolean isStop() {
    return linearMmPerS == 0 && angularRadPerS == 0;
  }
}
