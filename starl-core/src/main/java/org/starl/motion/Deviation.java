package org.starl.motion;

import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.part;

import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.Var;

/**
 * How far a robot's belief about its pose is from the true pose: believed minus true. A robot cannot
 * know it; a simulator, which knows both, traces it.
 *
 * @param xMm along the x axis of the world
 * @param yMm along its y axis
 * @param headingRad counter-clockwise
 * @param errorMm the bound that the robot believes its position error to have, in mm
 * @param errorRad the same of its heading
 */
public record Deviation(
    double xMm, double yMm, double headingRad, double errorMm, double errorRad) {

  // Clocks and rounding may be off by so much.
  private static final double SLACK_MM = 1;
  private static final double SLACK_RAD = 0.01;

  /** The traced variable. A robot without one believes in its true pose, nearly. */
  public static final Var<Deviation> VAR = Var.of("deviation", shape());

  /** Its source in the trace. */
  public static final Instance SOURCE = Instance.of("gps");

  /** No deviation at all. */
  public static final Deviation NONE = new Deviation(0, 0, 0, 0, 0);

  /** Of this belief from {@code truth}. */
  public static Deviation of(Location.Known belief, Pose truth) {
    Pose pose = belief.pose();
    return new Deviation(
        pose.xMm() - truth.xMm(),
        pose.yMm() - truth.yMm(),
        Angles.difference(pose.headingRad(), truth.headingRad()),
        belief.errorMm(),
        belief.errorRad());
  }

  /** The distance between the believed and the true position, in mm. */
  public double distanceMm() {
    return StrictMath.hypot(xMm, yMm);
  }

  /** Whether the true position is outside the robot's own error bound, by more than 1 mm. */
  public boolean isFalse() {
    return distanceMm() > errorMm + SLACK_MM;
  }

  /** Whether the true heading is outside the robot's own error bound, by more than 0.6 degrees. */
  public boolean isTurned() {
    return Math.abs(headingRad) > errorRad + SLACK_RAD;
  }

  /** Whether a picture of it would look different from one of {@code other}, by {@code leastMm}. */
  public boolean differs(Deviation other, double leastMm) {
    return isFalse() != other.isFalse()
        || isTurned() != other.isTurned()
        || StrictMath.hypot(xMm - other.xMm, yMm - other.yMm) > leastMm
        || StrictMath.abs(errorMm - other.errorMm) > leastMm;
  }

  /** The believed pose of a robot whose true pose is {@code truth}. */
  public Pose believed(Pose truth) {
    return Pose.of(
        truth.at().plus(new Point(xMm, yMm)), Angles.normalize(truth.headingRad() + headingRad));
  }

  /** {@code 600 mm off, error bound 5 mm}. */
  @Override
  public String toString() {
    return StrictMath.round(distanceMm())
        + " mm off, error bound "
        + StrictMath.round(StrictMath.ceil(errorMm))
        + " mm";
  }

  private static RecordShape<Deviation> shape() {
    return Shapes.of(
        Deviation.class,
        part("xMm", REAL, Deviation::xMm),
        part("yMm", REAL, Deviation::yMm),
        part("headingRad", REAL, Deviation::headingRad),
        part("errorMm", REAL, Deviation::errorMm),
        part("errorRad", REAL, Deviation::errorRad),
        Deviation::new);
  }
}
