package org.starl.primitives.geocast;

import static org.starl.time.Time.NS_PER_S;

import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.spec.Bodies;
import org.starl.time.Time;

/**
 * Decides whether a robot's true centre was ever in an area during an interval, and whether it was
 * always deep inside. Between events a body follows an arc. The steps along it cannot skip a
 * border, because a body moves by at most speed times time.
 *
 * <p>Closer to a border than the distance of one millisecond, both answers favour the robot: it was
 * inside, and not deep.
 */
final class Presence {

  private static final long MIN_STEP_NS = 1_000_000;

  // A recorded trace rounds each coordinate by up to half a micrometre.
  private static final double TOLERANCE_MM = 0.01;

  private final RobotId robot;
  private final Region area;
  private final double deepMm;
  private long checkedNs;
  private boolean everIn;
  private boolean alwaysDeep = true;

  /**
   * @param deepMm the least distance from the border deep inside
   * @param sinceNs the time now, with the body on the floor
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

  /** Records that the body left the floor during the interval. */
  void interrupted() {
    alwaysDeep = false;
  }

  /** Continues with a body that is on the floor again since {@code nowNs}. */
  void resume(long nowNs) {
    checkedNs = nowNs;
  }

  /** Follows the body, which moves at {@code speedMmPerS}, until {@code toNs}. */
  void follow(Bodies bodies, double speedMmPerS, long toNs) {
    double minStepMm = speedMmPerS * Time.seconds(MIN_STEP_NS);
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
