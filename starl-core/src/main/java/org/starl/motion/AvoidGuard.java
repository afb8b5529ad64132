package org.starl.motion;

import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.geometry.Sines;

/**
 * Keeps the whole body out of a region (paper, section 4.1, safety). It accepts a command only if
 * the disc around every position that the command can lead to, until the next step's command is
 * certainly in effect, is outside the region. This includes the error bounds of position and
 * heading, the wheels' speed error, the lingering effect of older commands, and sliding along a
 * touched object. Stopping is always safe: the check of the earlier commands covered everything
 * that the wheels may do until it is in effect. Pure.
 */
final class AvoidGuard {

  /**
   * Number of sampled positions on the arc; between them, the distance to the region is bounded by
   * their spacing.
   */
  private static final int SAMPLES = 4;

  /** Fractions of the commanded speed, tried in this order on the same arc. */
  private static final double[] SLOWER = {1, 0.5, 0.25, 0.1};

  private final Region avoid;
  private final double bodyMm;
  private final double reactionS;
  private final double horizonS;
  private final double mostSpeed;

  AvoidGuard(Region avoid, MotionParameters p) {
    this.avoid = avoid;
    this.bodyMm = p.robotRadiusMm();
    this.reactionS = p.reactionMs() / 1e3;
    this.horizonS = p.horizonS();
    this.mostSpeed = 1 + p.speedError();
  }

  /** Whether the body would touch the region at {@code target}. */
  boolean forbids(Point target) {
    return avoid.distanceMm(target) <= bodyMm;
  }

  /** The command, a slower one on the same arc, or STOP. */
  WheelCommand limit(
      WheelCommand command, Location.Known at, Bumps bumps, LingeringSpeeds lingering) {
    if (avoid instanceof Nowhere || command.linearMmPerS() == 0) {
      return command;
    }
    double nearMm = avoid.distanceMm(at.pose().at());
    for (double part : SLOWER) {
      WheelCommand slower =
          part == 1
              ? command
              : new WheelCommand(command.linearMmPerS() * part, command.angularRadPerS() * part);
      if (isSafe(slower, at, nearMm, bumps, lingering)) {
        return slower;
      }
    }
    return WheelCommand.STOP;
  }

  private boolean isSafe(
      WheelCommand command,
      Location.Known at,
      double nearMm,
      Bumps bumps,
      LingeringSpeeds lingering) {
    double mmPerS = Math.abs(command.linearMmPerS());
    double pathMm = mostSpeed * mmPerS * horizonS;
    // Without a contact now, it slides at most from the next contact until the stop that this
    // triggers.
    double slideMm = mostSpeed * mmPerS * (bumps.any() ? horizonS : reactionS);
    double lateMm = mostSpeed * lingering.beyondMmPerS(command.linearMmPerS()) * reactionS;
    double neededMm = bodyMm + at.errorMm() + slideMm + lateMm;
    if (nearMm - pathMm > neededMm) {
      return true;
    }
    double turnRad = Math.abs(command.angularRadPerS()) * horizonS;
    double lateRad = lingering.beyondRadPerS(command.angularRadPerS()) * reactionS;
    double offRad = at.errorRad() + mostSpeed * (turnRad + lateRad);
    return isPathClear(command, at.pose(), nearMm, pathMm, neededMm, offRad);
  }

  /** Checks the commanded arc, when the body may reach each point with this heading error. */
  private boolean isPathClear(
      WheelCommand command,
      Pose from,
      double nearMm,
      double pathMm,
      double neededMm,
      double offRad) {
    double stepMm = pathMm / SAMPLES;
    double stepS = mostSpeed * horizonS / SAMPLES;
    double chord = 2 * Sines.sin(Math.min(StrictMath.PI, offRad) / 2);
    double before = nearMm;
    for (int i = 1; i <= SAMPLES; i++) {
      Pose ahead =
          Kinematics.after(from, command.linearMmPerS(), command.angularRadPerS(), stepS * i);
      double after = avoid.distanceMm(ahead.at());
      // With the heading error, this position is off by at most its chord.
      double swingMm = chord * stepMm * i;
      if ((before + after - stepMm) / 2 - swingMm <= neededMm) {
        return false;
      }
      before = after;
    }
    return true;
  }
}
