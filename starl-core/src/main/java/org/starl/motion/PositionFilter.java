package org.starl.motion;

import org.jspecify.annotations.Nullable;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;

/**
 * Where a robot is, from its fixes and from what its wheels were told: a set-membership filter
 * (Schweppe, "Recursive state estimation: unknown but bounded errors and system inputs", 1968) whose
 * sets are discs. The belief is a disc that holds the true position for certain. It moves with the
 * commands and grows by the path that they command, because a body may be held up anywhere on it; a
 * fix is a disc too, and the new belief is the smallest disc around what the two have in common. The
 * heading is an interval in the same manner.
 *
 * <p>The bound is true if each fix's bound is, and if between two fixes the body runs along the
 * commanded arcs, no faster, while no bump sensor is closed; where one is, the body may slide
 * whatever way, no faster than commanded. A fix that has nothing in common with the belief breaks
 * one of these; it is counted and not believed, but from then on the bound holds both.
 *
 * <p>Pure: knows no port. Allocates nothing but the locations that are asked for.
 */
final class PositionFilter {

  private static final double NS_PER_S = 1e9;

  /** Two discs that miss each other by less have a point in common, up to rounding. */
  private static final double ROUNDING_MM = 1e-6;

  private final Odometry odometry = new Odometry();

  private boolean hasBelief;
  private long beliefNs;
  private double xMm;
  private double yMm;
  private double headingRad;
  private double radiusMm;
  private double spreadRad;
  private long fixNs;

  private long contradictions;
  private long outdated;

  /**
   * From {@code nowNs} on the wheels are told this, and do it at most {@code reactionNs} later; not
   * before the time of any earlier call.
   */
  void commanded(WheelCommand command, boolean bumped, long reactionNs, long nowNs) {
    odometry.commanded(command, bumped, reactionNs / NS_PER_S, nowNs);
  }

  boolean hasFix() {
    return hasBelief;
  }

  /** When the newest fix that was believed was measured. */
  long fixNs() {
    return fixNs;
  }

  /** Fixes that contradict the belief. */
  long contradictions() {
    return contradictions;
  }

  /** Fixes that were older than one before, or from the future. */
  long outdated() {
    return outdated;
  }

  /**
   * Learns a measurement.
   *
   * @return whether it was believed
   */
  boolean fixed(Fix fix, long nowNs) {
    long atNs = fix.timeNs();
    if (atNs > nowNs || (hasBelief && atNs < beliefNs)) {
      outdated++;
      return false;
    }
    if (!hasBelief || !odometry.reaches(beliefNs)) {
      anchor(fix);
      return true;
    }
    advanceTo(atNs);
    if (!meet(fix)) {
      contradictions++;
      return false;
    }
    meetHeading(fix);
    fixNs = atNs;
    return true;
  }

  /** The belief at {@code nowNs}, which is not before the last fix or command; null without one. */
  Location.@Nullable Known at(long nowNs) {
    if (!hasBelief) {
      return null;
    }
    odometry.locate(beliefNs, nowNs);
    double cos = StrictMath.cos(headingRad);
    double sin = StrictMath.sin(headingRad);
    Pose pose =
        new Pose(
            xMm + cos * odometry.forwardMm() - sin * odometry.leftMm(),
            yMm + sin * odometry.forwardMm() + cos * odometry.leftMm(),
            Angles.normalize(headingRad + odometry.turnRad()));
    double errorRad = Math.min(StrictMath.PI, spreadRad + odometry.turnedRad());
    double errorMm =
        odometry.reaches(beliefNs)
            ? radiusMm + growthMm(odometry.pathMm(), errorRad)
            : Double.POSITIVE_INFINITY;
    return new Location.Known(pose, errorMm, errorRad, nowNs, fixNs);
  }

  private void anchor(Fix fix) {
    hasBelief = true;
    beliefNs = fix.timeNs();
    fixNs = fix.timeNs();
    xMm = fix.pose().xMm();
    yMm = fix.pose().yMm();
    headingRad = fix.pose().headingRad();
    radiusMm = fix.errorMm();
    spreadRad = fix.errorRad();
  }

  private void advanceTo(long atNs) {
    odometry.locate(beliefNs, atNs);
    if (odometry.forwardMm() != 0 || odometry.leftMm() != 0) {
      double cos = StrictMath.cos(headingRad);
      double sin = StrictMath.sin(headingRad);
      xMm += cos * odometry.forwardMm() - sin * odometry.leftMm();
      yMm += sin * odometry.forwardMm() + cos * odometry.leftMm();
    }
    headingRad = Angles.normalize(headingRad + odometry.turnRad());
    spreadRad = Math.min(StrictMath.PI, spreadRad + odometry.turnedRad());
    radiusMm += growthMm(odometry.pathMm(), spreadRad);
    beliefNs = atNs;
  }

  /**
   * How far a body may be from where a path leads, that is somewhere on this path, turned by at most
   * {@code offRad}: after the part s of the path L, at most 2 s sin(off/2) + L - s.
   */
  private static double growthMm(double pathMm, double offRad) {
    return pathMm * Math.max(1, 2 * StrictMath.sin(Math.min(StrictMath.PI, offRad) / 2));
  }

  /** Intersects the belief with the fix's disc; if they have nothing in common, covers both. */
  private boolean meet(Fix fix) {
    double dx = fix.pose().xMm() - xMm;
    double dy = fix.pose().yMm() - yMm;
    double gapMm = Math.sqrt(dx * dx + dy * dy);
    double fixMm = fix.errorMm();
    if (gapMm > radiusMm + fixMm + ROUNDING_MM) {
      radiusMm = gapMm + fixMm;
      return false;
    }
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
    return true;
  }

  private void meetHeading(Fix fix) {
    double offRad = Angles.difference(fix.pose().headingRad(), headingRad);
    double low = Math.max(-spreadRad, offRad - fix.errorRad());
    double high = Math.min(spreadRad, offRad + fix.errorRad());
    boolean wraps = spreadRad + fix.errorRad() >= StrictMath.PI;
    if (wraps || low > high) {
      headingRad = fix.pose().headingRad();
      spreadRad = fix.errorRad();
    } else {
      headingRad = Angles.normalize(headingRad + (low + high) / 2);
      spreadRad = (high - low) / 2;
    }
  }
}
