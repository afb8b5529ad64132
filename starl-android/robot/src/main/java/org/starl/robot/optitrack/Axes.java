package org.starl.robot.optitrack;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;

/**
 * Converts a stream's coordinates to StarL's. Both systems are right-handed, so this is a rotation,
 * and metres become millimetres: with z up (x, y, z) is kept, with y up it becomes (x, -z, y). The
 * heading is the direction of the body's forward axis on the floor, counter-clockwise from StarL's x.
 *
 * @param up the stream's axis that points up
 * @param forward the body's axis that points in the robot's driving direction; not the axis that
 *     points up
 */
public record Axes(UpAxis up, BodyAxis forward) {

  /** Motive's default, with bodies defined while the robots face x. */
  public static final Axes DEFAULT = new Axes(UpAxis.Y, BodyAxis.PLUS_X);

  private static final double MM_PER_M = 1000;

  /** A body whose forward axis is steeper than this does not stand on the floor: 60 degrees. */
  private static final double LEAST_LEVEL = 0.5;

  private static final double LARGEST_M = 10_000;
  private static final double UNIT_TOLERANCE = 0.02;

  public Axes {
    if (up == UpAxis.Y ? forward.y != 0 : forward.z != 0) {
      throw new IllegalArgumentException(
          "forward axis " + forward + " with " + up + " up: expected an axis that is level");
    }
  }

  /**
   * The pose of a body at (x, y, z), in metres, with the orientation (qx, qy, qz, qw), a unit quaternion; null if no body on a floor
   * can have it, or if numbers are not finite.
   */
  public @Nullable Pose pose(
      double x, double y, double z, double qx, double qy, double qz, double qw) {
    return pose(new RigidBodyState(0, x, y, z, qx, qy, qz, qw, 0, true));
  }

  /** The body's pose; null if no body on a floor can have it, or if numbers are not finite. */
  @Nullable Pose pose(RigidBodyState body) {
    double norm =
        body.qx() * body.qx()
            + body.qy() * body.qy()
            + body.qz() * body.qz()
            + body.qw() * body.qw();
    // Also false for NaN.
    if (!(Math.abs(norm - 1) <= UNIT_TOLERANCE)
        || !isNear(body.x())
        || !isNear(body.y())
        || !isNear(body.z())) {
      return null;
    }
    double ahead = ahead(body);
    double aside = aside(body);
    if (StrictMath.sqrt(ahead * ahead + aside * aside) < LEAST_LEVEL) {
      return null;
    }
    return new Pose(
        MM_PER_M * body.x(),
        MM_PER_M * (up == UpAxis.Y ? -body.z() : body.y()),
        StrictMath.atan2(aside, ahead));
  }

  /** Height of the body's pivot above the floor. */
  double heightMm(RigidBodyState body) {
    return MM_PER_M * (up == UpAxis.Y ? body.y() : body.z());
  }

  /** The inverse of {@link #pose} for a body that stands level. */
  RigidBodyState state(int id, Pose pose, double heightMm, double meanErrorMm, boolean isTracked) {
    double unturnedRad = StrictMath.atan2(up == UpAxis.Y ? -forward.z : forward.y, forward.x);
    double halfRad = (pose.headingRad() - unturnedRad) / 2;
    double sine = StrictMath.sin(halfRad);
    double cosine = StrictMath.cos(halfRad);
    double xM = pose.xMm() / MM_PER_M;
    double yM = pose.yMm() / MM_PER_M;
    double heightM = heightMm / MM_PER_M;
    double meanErrorM = meanErrorMm / MM_PER_M;
    return up == UpAxis.Y
        ? new RigidBodyState(id, xM, heightM, -yM, 0, sine, 0, cosine, meanErrorM, isTracked)
        : new RigidBodyState(id, xM, yM, heightM, 0, 0, sine, cosine, meanErrorM, isTracked);
  }

  /** The forward axis, rotated by the body's quaternion: its component along StarL's x. */
  private double ahead(RigidBodyState b) {
    return (1 - 2 * (b.qy() * b.qy() + b.qz() * b.qz())) * forward.x
        + 2 * (b.qx() * b.qy() - b.qz() * b.qw()) * forward.y
        + 2 * (b.qx() * b.qz() + b.qy() * b.qw()) * forward.z;
  }

  /** Its component along StarL's y. */
  private double aside(RigidBodyState b) {
    return up == UpAxis.Y
        ? -(2 * (b.qx() * b.qz() - b.qy() * b.qw()) * forward.x
            + 2 * (b.qy() * b.qz() + b.qx() * b.qw()) * forward.y
            + (1 - 2 * (b.qx() * b.qx() + b.qy() * b.qy())) * forward.z)
        : 2 * (b.qx() * b.qy() + b.qz() * b.qw()) * forward.x
            + (1 - 2 * (b.qx() * b.qx() + b.qz() * b.qz())) * forward.y
            + 2 * (b.qy() * b.qz() - b.qx() * b.qw()) * forward.z;
  }

  private static boolean isNear(double metres) {
    return Math.abs(metres) <= LARGEST_M;
  }
}
