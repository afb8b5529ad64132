package org.starl.motion;

import static org.starl.time.Time.NS_PER_MS;

import org.starl.body.MotionParameters;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;

/**
 * Tells a motion that goes nowhere: wheels that are told to turn and a pose that stays the same
 * (held up without a bump, stuck wheels), or much driving without coming nearer. Pure.
 */
final class ProgressWatch {

  /** What a held-up body seems to move between two fixes, because its wheels are told to. */
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

  /** Time passed in which the wheels were stopped on purpose: who stands then is not stuck. */
  void excuse(long ns) {
    movedNs += ns;
  }

  /**
   * Whether it goes nowhere.
   *
   * @param bearingRad angle between the heading and the target
   */
  boolean isStuck(Location.Known at, double distanceMm, double bearingRad) {
    long nowNs = at.timeNs();
    if (!begun || hasMoved(at)) {
      begun = true;
      anchor = at.pose();
      movedNs = nowNs;
    }
    if (isNearer(distanceMm, Math.abs(bearingRad))) {
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

  /** Turning towards the target is progress too, as long as it leads on to coming nearer. */
  private boolean isNearer(double distanceMm, double offRad) {
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
