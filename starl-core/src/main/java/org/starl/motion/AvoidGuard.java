package org.starl.motion;

import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;

/**
 * Keeps the whole body out of a region (paper, section 4.1, safety). A command is let through only
 * if the disc around every position that it can lead to, until the next step's is in effect for
 * certain, lies outside. In it are: the error bounds of position and heading, the wheels' speed
 * error, what they may still do of older commands, and sliding along what the body touches. Stopping
 * is always safe: whatever the wheels may do until it is in effect was in the check of the commands
 * that they follow. Pure.
 */
final class AvoidGuard {

  /** Positions between which the distance from the region is bounded by how far apart they are. */
  private static final int SAMPLES = 4;

  /** Commands of the same arc at these parts of the speed are tried in turn. */
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

  /** Whether the body would be in the region at {@code target}. */
  boolean forbids(Point target) {
    return avoid.distanceMm(target) <= bodyMm;
  }

  /** The command, or a slower one of the same arc, or STOP. */
  WheelCommand limit(WheelCommand command, Location.Known at, Bumps bumps, Lingering lingering) {
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
      WheelCommand command, Location.Known at, double nearMm, Bumps bumps, Lingering lingering) {
    double mmPerS = Math.abs(command.linearMmPerS());
    double pathMm = mostSpeed * mmPerS * horizonS;
    // Without a contact now it slides at most from the next one until the stop that it brings.
    double slideMm = mostSpeed * mmPerS * (bumps.any() ? horizonS : reactionS);
    double lateMm = mostSpeed * lingering.beyondMmPerS(command.linearMmPerS()) * reactionS;
    double neededMm = bodyMm + at.errorMm() + slideMm + lateMm;
    if (nearMm - pathMm > neededMm) {
      return true;
    }
    double turnRad = Math.abs(command.angularRadPerS()) * horizonS;
    double lateRad = lingering.beyondRadPerS(command.angularRadPerS()) * reactionS;
    double offRad = at.errorRad() + mostSpeed * (turnRad + lateRad);
    return isWayClear(command, at.pose(), nearMm, pathMm, neededMm, offRad);
  }

  /** Along the commanded arc, each point of which the body reaches with its heading so far off. */
  private boolean isWayClear(
      WheelCommand command,
      Pose from,
      double nearMm,
      double pathMm,
      double neededMm,
      double offRad) {
    double stepMm = pathMm / SAMPLES;
    double stepS = mostSpeed * horizonS / SAMPLES;
    double chord = 2 * StrictMath.sin(Math.min(StrictMath.PI, offRad) / 2);
    double before = nearMm;
    for (int i = 1; i <= SAMPLES; i++) {
      Pose ahead =
          Kinematics.after(from, command.linearMmPerS(), command.angularRadPerS(), stepS * i);
      double after = avoid.distanceMm(ahead.at());
      // Turned by the heading's error, this position lies off by at most its chord.
      double swingMm = chord * stepMm * i;
      if ((before + after - stepMm) / 2 - swingMm <= neededMm) {
        return false;
      }
      before = after;
    }
    return true;
  }
}
