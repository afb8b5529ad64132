package org.starl.motion;

import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Sines;

/**
 * The state of {@link PositionFilter}: a disc that contains the robot's position at one time, and
 * an interval that contains its heading.
 */
final class PoseEstimate {

  /** Rounding tolerance: discs closer than this count as intersecting. */
  private static final double ROUNDING_MM = 1e-6;

  private static final double ROUNDING_RAD = 1e-9;

  private long atNs;
  private double xMm;
  private double yMm;
  private double headingRad;
  private double radiusMm;
  private double spreadRad;

  // Of the heading for which they were asked last.
  private double directionRad = Double.NaN;
  private double cosine;
  private double sine;

  /** The estimate from one fix alone. */
  PoseEstimate(Fix fix) {
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

  /** Predicts the state at {@code nowNs} from the commands since {@link #atNs}. */
  void advanceTo(long nowNs, Odometry odometry) {
    odometry.locate(atNs, nowNs);
    xMm = aheadXMm(odometry);
    yMm = aheadYMm(odometry);
    radiusMm = aheadRadiusMm(odometry);
    headingRad = aheadRad(odometry);
    spreadRad = aheadSpreadRad(odometry);
    atNs = nowNs;
  }

  // The predicted state for the interval that odometry located last.

  double aheadXMm(Odometry odometry) {
    return odometry.forwardMm() == 0 && odometry.leftMm() == 0
        ? xMm
        : xMm + cosine() * odometry.forwardMm() - sine() * odometry.leftMm();
  }

  double aheadYMm(Odometry odometry) {
    return odometry.forwardMm() == 0 && odometry.leftMm() == 0
        ? yMm
        : yMm + sine() * odometry.forwardMm() + cosine() * odometry.leftMm();
  }

  private double cosine() {
    updateDirection();
    return cosine;
  }

  private double sine() {
    updateDirection();
    return sine;
  }

  private void updateDirection() {
    if (Double.compare(directionRad, headingRad) != 0) {
      directionRad = headingRad;
      cosine = Sines.cos(headingRad);
      sine = Sines.sin(headingRad);
    }
  }

  double aheadRad(Odometry odometry) {
    return Angles.normalize(headingRad + odometry.turnRad());
  }

  double aheadSpreadRad(Odometry odometry) {
    return Math.min(StrictMath.PI, spreadRad + odometry.turnedRad());
  }

  /**
   * If a body executes between 0 and 1 + e times of each piece of a path, with a heading error of
   * at most d, its error per piece is at most |(1 + e) u' - u| or |u|, whichever is larger, where u
   * and u' are the directions.
   */
  double aheadRadiusMm(Odometry odometry) {
    if (odometry.pathMm() == 0) {
      return radiusMm + odometry.strayMm();
    }
    double e = odometry.speedError();
    double chord = 2 * Sines.sin(aheadSpreadRad(odometry) / 2);
    double most = Math.max(1, Math.sqrt(e * e + (1 + e) * chord * chord));
    return radiusMm + odometry.pathMm() * most + odometry.strayMm();
  }

  /**
   * Updates the state with a fix of the same time: the smallest disc around the intersection.
   *
   * @return false if the intersection is empty; then nothing changes
   */
  boolean intersect(Fix fix) {
    double dx = fix.pose().xMm() - xMm;
    double dy = fix.pose().yMm() - yMm;
    double gapMm = Math.sqrt(dx * dx + dy * dy);
    double offRad = Angles.difference(fix.pose().headingRad(), headingRad);
    if (gapMm > radiusMm + fix.errorMm() + ROUNDING_MM
        || Math.abs(offRad) > spreadRad + fix.errorRad() + ROUNDING_RAD) {
      return false;
    }
    intersectDisc(fix, dx, dy, gapMm);
    intersectHeading(fix, offRad);
    return true;
  }

  private void intersectDisc(Fix fix, double dx, double dy, double gapMm) {
    double fixMm = fix.errorMm();
    // Where the line through the intersection points of both circles meets the line of centres.
    double chordMm =
        gapMm == 0 ? 0 : (gapMm * gapMm + radiusMm * radiusMm - fixMm * fixMm) / (2 * gapMm);
    boolean fixIsInside = gapMm + fixMm <= radiusMm || (gapMm > 0 && chordMm >= gapMm);
    boolean estimateIsInside = gapMm + radiusMm <= fixMm || (gapMm > 0 && chordMm <= 0);
    if (fixIsInside) {
      xMm = fix.pose().xMm();
      yMm = fix.pose().yMm();
      radiusMm = fixMm;
    } else if (!estimateIsInside) {
      xMm += dx * (chordMm / gapMm);
      yMm += dy * (chordMm / gapMm);
      radiusMm = Math.sqrt(Math.max(0, radiusMm * radiusMm - chordMm * chordMm));
    }
  }

  private void intersectHeading(Fix fix, double offRad) {
    boolean wraps = spreadRad + fix.errorRad() >= StrictMath.PI;
    if (!wraps) {
      double low = Math.max(-spreadRad, offRad - fix.errorRad());
      double high = Math.min(spreadRad, offRad + fix.errorRad());
      headingRad = Angles.normalize(headingRad + (low + high) / 2);
      spreadRad = Math.max(0, high - low) / 2;
    } else if (fix.errorRad() <= spreadRad) {
      // The intervals may overlap on both sides of the circle: the narrower one contains the
      // intersection.
      headingRad = fix.pose().headingRad();
      spreadRad = fix.errorRad();
    }
  }
}
