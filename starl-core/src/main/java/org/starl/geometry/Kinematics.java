package org.starl.geometry;

/**
 * Motion with constant forward speed v and constant turning speed w: an arc, in closed form. In the
 * time t the body turns by a = w t, and its displacement is a chord of length v t sinc(a/2) in the
 * direction heading + a/2 (Siegwart, Nourbakhsh, "Autonomous Mobile Robots", section 3.2). In this
 * form a small w loses no precision, and w = 0 is not a special case.
 */
public final class Kinematics {

  /** Below this, 1 - x^2/6 equals sin(x)/x to the last bit. */
  private static final double SMALL = 1e-4;

  private Kinematics() {}

  /** The pose after {@code seconds}; negative values give earlier poses. */
  public static Pose after(Pose start, double linearMmPerS, double angularRadPerS, double seconds) {
    double turn = angularRadPerS * seconds;
    double chordMm = chordMm(linearMmPerS, turn, seconds);
    double direction = start.headingRad() + turn / 2;
    if (chordMm == 0) {
      return new Pose(start.xMm(), start.yMm(), Angles.normalize(start.headingRad() + turn));
    }
    return new Pose(
        start.xMm() + chordMm * Sines.cos(direction),
        start.yMm() + chordMm * Sines.sin(direction),
        Angles.normalize(start.headingRad() + turn));
  }

  /**
   * Length of the chord of an arc that turns by {@code turnRad}; negative when driving backwards.
   */
  public static double chordMm(double linearMmPerS, double turnRad, double seconds) {
    return linearMmPerS == 0 ? 0 : linearMmPerS * seconds * sinc(turnRad / 2);
  }

  private static double sinc(double x) {
    return Math.abs(x) < SMALL ? 1 - x * x / 6 : Sines.sin(x) / x;
  }
}
