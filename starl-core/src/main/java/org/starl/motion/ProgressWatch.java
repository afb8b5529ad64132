package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import org.starl.body.MotionParameters;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;

/**
 * Detects a motion without progress: the wheels should turn but the pose stays the same (blocked
 * without a bump, stuck wheels), or the robot drives without coming nearer. Pure.
 */
final class ProgressWatch {

  /** Apparent movement of a blocked body between two fixes, because its wheels are commanded. */
  private static final double STILL_MM = 40;

  private static final double STILL_RAD = Angles.fromDegrees(15);
  private static final double NEARER_MM = 5;
  private static final double NEARER_RAD = Angles.fromDegrees(5);

  private final MotionParameters p;
  private boolean begun;
  private Pose anchor = new Pose(0, 0, 0);
  private long movedNs;
  private double bestMm = Double.POSITIVE_INFINITY;
  private double bestRad = Double.POSITIVE_INFINITY;
  private long nearerNs;

  ProgressWatch(MotionParameters parameters) {
    this.p = parameters;
  }

  /** Excludes a time in which the wheels were stopped on purpose. */
  void excuse(long ns) {
    movedNs += ns;
  }

  /**
   * Processes the location of a step.
   *
   * @param bearingRad angle between the heading and the target
   * @return whether the motion is stuck
   */
  boolean update(Location.Known at, double distanceMm, double bearingRad) {
    long nowNs = at.timeNs();
    if (!begun || hasMoved(at)) {
      begun = true;
      anchor = at.pose();
      movedNs = nowNs;
    }
    if (updateBest(distanceMm, Math.abs(bearingRad))) {
      nearerNs = nowNs;
    }
    return nowNs - movedNs >= p.stuckAfterMs() * NS_PER_MS
        || nowNs - nearerNs >= p.noProgressMs() * NS_PER_MS;
  }

  private boolean hasMoved(Location.Known at) {
    double turned = Angles.difference(at.pose().headingRad(), anchor.headingRad());
    return at.pose().distanceMm(anchor.at()) > STILL_MM + 2 * at.errorMm()
        || Math.abs(turned) > STILL_RAD + 2 * at.errorRad();
  }

  /**
   * Updates the smallest distance and bearing. Turning towards the target counts as progress too, as
   * long as the robot then comes nearer.
   *
   * @return whether either improved
   */
  private boolean updateBest(double distanceMm, double offRad) {
    if (distanceMm < bestMm - NEARER_MM) {
      bestMm = distanceMm;
      bestRad = offRad;
      return true;
    }
    if (offRad < bestRad - NEARER_RAD) {
      bestRad = offRad;
      return true;
    }
    return false;
  }
}
