package org.starl.motion;

import org.starl.geometry.Kinematics;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;

/**
 * Keeps the whole body out of a region (paper, section 4.1, safety). A command is let through only
 * if the disc around every position that it can lead to, until the step after it takes effect, lies
 * outside: the position's error bound, the heading's, and the commanded speed are in it. Since a
 * body that stops stays where it is, and the last command let through was safe until now, stopping
 * is always safe. Pure.
 */
final class AvoidGuard {

  /** Positions between which the distance from the region is bounded by how far apart they are. */
  private static final int SAMPLES = 4;

  /** Commands of the same arc at these parts of the speed are tried in turn. */
  private static final double[] SLOWER = {1, 0.5, 0.25, 0.1};

  private final Region avoid;
  private final double bodyMm;
  private final double horizonS;

  AvoidGuard(Region avoid, MotionParameters p) {
    this.avoid = avoid;
    this.bodyMm = p.robotRadiusMm();
    this.horizonS = (p.automatonPeriodMs() + p.reactionMs()) / 1e3;
  }

  /** Whether the body would be in the region at {@code target}. */
  boolean forbids(Point target) {
    return avoid.distanceMm(target) <= bodyMm;
  }

  /** The command, or a slower one of the same arc, or STOP. */
  WheelCommand limit(WheelCommand command, Location.Known at) {
    if (avoid instanceof Nowhere || command.linearMmPerS() == 0) {
      return command;
    }
    double nearMm = avoid.distanceMm(at.pose().at());
    for (double part : SLOWER) {
      WheelCommand slower =
          part == 1
              ? command
              : new WheelCommand(command.linearMmPerS() * part, command.angularRadPerS() * part);
      if (isSafe(slower, at, nearMm)) {
        return slower;
      }
    }
    return WheelCommand.STOP;
  }

  private boolean isSafe(WheelCommand command, Location.Known at, double nearMm) {
    double neededMm = bodyMm + at.errorMm();
    double pathMm = Math.abs(command.linearMmPerS()) * horizonS;
    if (nearMm - pathMm > neededMm) {
      return true;
    }
    double stepMm = pathMm / SAMPLES;
    double swingRad = Math.min(StrictMath.PI, at.errorRad());
    double before = nearMm;
    for (int i = 1; i <= SAMPLES; i++) {
      Pose ahead =
          Kinematics.after(
              at.pose(), command.linearMmPerS(), command.angularRadPerS(), horizonS * i / SAMPLES);
      double after = avoid.distanceMm(ahead.at());
      // Turned by the heading's error, this position lies off by at most its chord.
      double swingMm = 2 * StrictMath.sin(swingRad / 2) * stepMm * i;
      if ((before + after - stepMm) / 2 - swingMm <= neededMm) {
        return false;
      }
      before = after;
    }
    return true;
  }
}
