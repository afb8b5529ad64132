package org.starl.motion;

import org.jspecify.annotations.Nullable;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;

/**
 * Estimates a robot's position from its fixes and its wheel commands: a set-membership filter
 * (Schweppe, "Recursive state estimation: unknown but bounded errors and system inputs", 1968)
 * whose sets are discs. The estimate is a disc that certainly contains the true position. It moves
 * with the commands and grows by a true body's possible deviation (see {@link Odometry}); a fix is
 * a disc too, and the new estimate is the smallest disc around the intersection of both. The
 * heading is an interval, treated in the same way.
 *
 * <p>The bound is correct if each fix's bound is, and if the body follows its commands as {@link
 * Odometry} describes.
 *
 * <p>A fix that does not intersect the estimate, in position or in heading, violates one of these
 * assumptions. It is counted and not used; but until a fix agrees with the estimate again, the
 * bound also covers the fix's position. If fixes contradict the estimate and agree with each other
 * for {@link #SETTLE_NS}, the estimate was wrong (someone carried the robot), and they replace it.
 *
 * <p>Pure: uses no port. Allocates only the locations that are asked for, and rarely an estimate.
 */
final class PositionFilter {

  /** Contradicting fixes are accepted after they have agreed with each other for this time. */
  static final long SETTLE_NS = 30_000_000_000L;

  private final Odometry odometry = new Odometry();

  private @Nullable PoseEstimate estimate;
  private long fixNs;

  // The estimate from the fixes that contradict the main one, since the last fix that agreed with
  // it.
  private @Nullable PoseEstimate rival;
  private long rivalSinceNs;

  private long contradictions;
  private long outdated;

  // The location that was asked last: one action asks many times. Null after a fix or a command.
  private Location.@Nullable Known asked;

  /** Assumes wheels of this quality from now on ({@link Odometry#assume}). */
  void assume(double speedError, long reactionNs) {
    asked = null;
    odometry.assume(speedError, reactionNs);
  }

  /**
   * Records a wheel command, and whether a bump sensor is closed. Times must not decrease from call
   * to call.
   */
  void commanded(WheelCommand command, boolean bumped, long nowNs) {
    asked = null;
    odometry.commanded(command, bumped, nowNs);
    // A closing and opening bump sensor may cause any number of commands between two fixes.
    long coveredFromNs = odometry.coveredFromNs(nowNs);
    if (coveredFromNs > Long.MIN_VALUE) {
      advance(estimate, coveredFromNs);
      advance(rival, coveredFromNs);
      odometry.forget();
    }
  }

  private void advance(@Nullable PoseEstimate old, long toNs) {
    if (old != null && old.atNs() < toNs) {
      old.advanceTo(toNs, odometry);
    }
  }

  /** The commands that may still be in effect if a new one is given at {@code nowNs}. */
  LingeringSpeeds lingering(long nowNs) {
    return odometry.lingering(nowNs);
  }

  boolean hasFix() {
    return estimate != null;
  }

  /** Measurement time of the newest accepted fix. */
  long fixNs() {
    return fixNs;
  }

  /** Number of fixes that contradicted the estimate. */
  long contradictions() {
    return contradictions;
  }

  /** Whether no fix has agreed with the estimate since the last one that contradicted it. */
  boolean isContradicted() {
    return rival != null;
  }

  /** Number of fixes that were older than the estimate or the stored commands, or from the future. */
  long outdated() {
    return outdated;
  }

  /**
   * Processes a fix.
   *
   * @return whether it was accepted
   */
  boolean fixed(Fix fix, long nowNs) {
    asked = null;
    PoseEstimate known = estimate;
    long sinceNs = known == null ? odometry.coveredSinceNs() : known.atNs();
    if (fix.timeNs() < sinceNs || fix.timeNs() > nowNs) {
      outdated++;
      return false;
    }
    boolean isAccepted = update(known, fix);
    // All estimates are of its time now.
    odometry.forgetBefore(fix.timeNs());
    return isAccepted;
  }

  private boolean update(@Nullable PoseEstimate known, Fix fix) {
    if (known == null) {
      accept(new PoseEstimate(fix), fix);
      return true;
    }
    known.advanceTo(fix.timeNs(), odometry);
    if (known.intersect(fix)) {
      accept(known, fix);
      return true;
    }
    contradictions++;
    PoseEstimate other = updateRival(fix);
    if (fix.timeNs() - rivalSinceNs >= SETTLE_NS) {
      accept(other, fix);
      return true;
    }
    return false;
  }

  private void accept(PoseEstimate newEstimate, Fix fix) {
    estimate = newEstimate;
    fixNs = fix.timeNs();
    rival = null;
  }

  /** Updates the rival estimate; a fix that contradicts it too starts a new one. */
  private PoseEstimate updateRival(Fix fix) {
    PoseEstimate other = rival;
    if (other != null) {
      other.advanceTo(fix.timeNs(), odometry);
      if (other.intersect(fix)) {
        return other;
      }
    }
    other = new PoseEstimate(fix);
    rival = other;
    rivalSinceNs = fix.timeNs();
    return other;
  }

  /**
   * The location at {@code nowNs}, which is not before the last fix or command; null before the
   * first fix.
   */
  Location.@Nullable Known at(long nowNs) {
    if (estimate != null && (asked == null || asked.timeNs() != nowNs)) {
      Location.Known at = ahead(estimate, nowNs);
      asked = rival == null ? at : around(at, ahead(rival, nowNs));
    }
    return asked;
  }

  private Location.Known ahead(PoseEstimate from, long nowNs) {
    odometry.locate(from.atNs(), nowNs);
    Pose pose = new Pose(from.aheadXMm(odometry), from.aheadYMm(odometry), from.aheadRad(odometry));
    return new Location.Known(
        pose, from.aheadRadiusMm(odometry), from.aheadSpreadRad(odometry), nowNs, fixNs);
  }

  /** The pose of {@code one}, with bounds that cover both. */
  private static Location.Known around(Location.Known one, Location.Known other) {
    double offRad = Angles.difference(other.pose().headingRad(), one.pose().headingRad());
    double errorRad = Math.abs(offRad) + other.errorRad();
    return new Location.Known(
        one.pose(),
        Math.max(one.errorMm(), one.pose().distanceMm(other.pose().at()) + other.errorMm()),
        Math.min(StrictMath.PI, Math.max(one.errorRad(), errorRad)),
        one.timeNs(),
        one.fixNs());
  }
}
