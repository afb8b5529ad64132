package org.starl.motion;

import org.starl.geometry.Angles;
import org.starl.geometry.Fix;

/**
 * A disc that holds a robot's position at one time, and an interval that holds its heading: what
 * {@link PositionFilter} works on.
 */
final class Belief {

  /** Two discs that miss each other by less have a point in common, up to rounding. */
  private static final double ROUNDING_MM = 1e-6;

  private static final double ROUNDING_RAD = 1e-9;

  private long atNs;
  private double xMm;
  private double yMm;
  private double headingRad;
  private double radiusMm;
  private double spreadRad;

  /** What one fix alone says. */
  Belief(Fix fix) {
    become(fix);
  }

  private void become(Fix fix) {
    atNs = fix.timeNs();
    xMm = fix.pose().xMm();
    yMm = fix.pose().yMm();
    headingRad = fix.pose().headingRad();
    radiusMm = fix.errorMm();
    spreadRad = fix.errorRad();
  }

  long atNs() {
    return atNs;
  }

  /** Moves on with the commands since. */
  void advanceTo(long nowNs, Odometry odometry) {
    odometry.locate(atNs, nowNs);
    xMm = aheadXMm(odometry);
    yMm = aheadYMm(odometry);
    radiusMm = aheadRadiusMm(odometry);
    headingRad = aheadRad(odometry);
    spreadRad = aheadSpreadRad(odometry);
    atNs = nowNs;
  }

  // Where it is, seen from where odometry was asked to locate it from.

  double aheadXMm(Odometry odometry) {
    return odometry.forwardMm() == 0 && odometry.leftMm() == 0
        ? xMm
        : xMm
            + StrictMath.cos(headingRad) * odometry.forwardMm()
            - StrictMath.sin(headingRad) * odometry.leftMm();
  }

  double aheadYMm(Odometry odometry) {
    return odometry.forwardMm() == 0 && odometry.leftMm() == 0
        ? yMm
        : yMm
            + StrictMath.sin(headingRad) * odometry.forwardMm()
            + StrictMath.cos(headingRad) * odometry.leftMm();
  }

  double aheadRad(Odometry odometry) {
    return Angles.normalize(headingRad + odometry.turnRad());
  }

  double aheadSpreadRad(Odometry odometry) {
    return Math.min(StrictMath.PI, spreadRad + odometry.turnedRad());
  }

  /**
   * A body that does from none to 1 + e times of each piece of a path, turned by at most d, is off by
   * at most |(1 + e) u' - u| or |u| of that piece, u and u' being the directions: whichever is more.
   */
  double aheadRadiusMm(Odometry odometry) {
    if (odometry.pathMm() == 0) {
      return radiusMm + odometry.strayMm();
    }
    double e = odometry.speedError();
    double chord = 2 * StrictMath.sin(aheadSpreadRad(odometry) / 2);
    double most = Math.max(1, Math.sqrt(e * e + (1 + e) * chord * chord));
    return radiusMm + odometry.pathMm() * most + odometry.strayMm();
  }

  /**
   * Learns a fix of the same time: becomes the smallest disc around what it has in common with it.
   *
   * @return false if they have nothing in common; then nothing changes
   */
  boolean meet(Fix fix) {
    double dx = fix.pose().xMm() - xMm;
    double dy = fix.pose().yMm() - yMm;
    double gapMm = Math.sqrt(dx * dx + dy * dy);
    double offRad = Angles.difference(fix.pose().headingRad(), headingRad);
    if (gapMm > radiusMm + fix.errorMm() + ROUNDING_MM
        || Math.abs(offRad) > spreadRad + fix.errorRad() + ROUNDING_RAD) {
      return false;
    }
    meetDisc(fix, dx, dy, gapMm);
    meetHeading(fix, offRad);
    return true;
  }

  private void meetDisc(Fix fix, double dx, double dy, double gapMm) {
    double fixMm = fix.errorMm();
    // Where the line through the two points common to both circles cuts the line of centres.
    double chordMm =
        gapMm == 0 ? 0 : (gapMm * gapMm + radiusMm * radiusMm - fixMm * fixMm) / (2 * gapMm);
    boolean fixIsInside = gapMm + fixMm <= radiusMm || (gapMm > 0 && chordMm >= gapMm);
    boolean beliefIsInside = gapMm + radiusMm <= fixMm || (gapMm > 0 && chordMm <= 0);
    if (fixIsInside) {
      xMm = fix.pose().xMm();
      yMm = fix.pose().yMm();
      radiusMm = fixMm;
    } else if (!beliefIsInside) {
      xMm += dx * (chordMm / gapMm);
      yMm += dy * (chordMm / gapMm);
      radiusMm = Math.sqrt(Math.max(0, radiusMm * radiusMm - chordMm * chordMm));
    }
  }

  private void meetHeading(Fix fix, double offRad) {
    boolean wraps = spreadRad + fix.errorRad() >= StrictMath.PI;
    if (!wraps) {
      double low = Math.max(-spreadRad, offRad - fix.errorRad());
      double high = Math.min(spreadRad, offRad + fix.errorRad());
      headingRad = Angles.normalize(headingRad + (low + high) / 2);
      spreadRad = Math.max(0, high - low) / 2;
    } else if (fix.errorRad() <= spreadRad) {
      // They may meet on both sides of the circle: the narrower one holds what they have in common.
      headingRad = fix.pose().headingRad();
      spreadRad = fix.errorRad();
    }
  }
}
