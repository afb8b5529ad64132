package org.starl.primitives.geocast;

import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;

/**
 * Whether one robot's true centre was in an area at some time of an interval, and whether it was
 * deep in it at all times. Between events a body follows its arc; we walk along it in steps that
 * cannot step over a border, since nobody covers more ground than speed times time.
 *
 * <p>Nearer to a border than a millisecond's drive, both answers are the mild ones: it was inside,
 * and not deep.
 */
final class Presence {

  private static final long MIN_STEP_NS = 1_000_000;
  private static final double NS_PER_S = 1e9;

  // A recorded trace has lost up to half a micrometre a coordinate.
  private static final double TOLERANCE_MM = 0.01;

  private final RobotId robot;
  private final Region area;
  private final double deepMm;
  private long checkedNs;
  private boolean everIn;
  private boolean alwaysDeep = true;

  /**
   * @param deepMm deep is at least this far from the border
   * @param sinceNs the robot's body is on the floor now
   */
  Presence(RobotId robot, Region area, double deepMm, long sinceNs) {
    this.robot = robot;
    this.area = area;
    this.deepMm = deepMm;
    this.checkedNs = sinceNs;
  }

  boolean everIn() {
    return everIn;
  }

  boolean alwaysDeep() {
    return alwaysDeep;
  }

  /** The body was not on the floor all the time. */
  void interrupted() {
    alwaysDeep = false;
  }

  /** The body has been on the floor only since {@code nowNs}. */
  void resume(long nowNs) {
    checkedNs = nowNs;
  }

  /** Follows the body until {@code toNs}, up to which it moved at {@code speedMmPerS}. */
  void follow(Bodies bodies, double speedMmPerS, long toNs) {
    double minStepMm = speedMmPerS * (MIN_STEP_NS / NS_PER_S);
    while (alwaysDeep || !everIn) {
      Point at = bodies.poseAt(robot, checkedNs).at();
      double outsideMm = area.distanceMm(at) - TOLERANCE_MM;
      double deeperMm = area.depthMm(at) - deepMm - TOLERANCE_MM;
      everIn |= outsideMm <= minStepMm;
      alwaysDeep &= deeperMm > minStepMm;
      double safeMm =
          Math.min(
              everIn ? Double.POSITIVE_INFINITY : outsideMm,
              alwaysDeep ? deeperMm : Double.POSITIVE_INFINITY);
      double safeNs = safeMm / speedMmPerS * NS_PER_S;
      if (!(safeNs < toNs - checkedNs)) {
        break;
      }
      checkedNs += Math.max(MIN_STEP_NS, (long) safeNs);
    }
    checkedNs = toNs;
  }
}
