package org.starl.motion;

import org.jspecify.annotations.Nullable;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;

/**
 * Where a robot is, from its fixes and from what its wheels were told: a set-membership filter
 * (Schweppe, "Recursive state estimation: unknown but bounded errors and system inputs", 1968) whose
 * sets are discs. The belief is a disc that holds the true position for certain. It moves with the
 * commands and grows by what a true body may do otherwise (see {@link Odometry}); a fix is a disc
 * too, and the new belief is the smallest disc around what the two have in common. The heading is an
 * interval in the same manner.
 *
 * <p>The bound is true if each fix's bound is, and if the body follows its commands as {@link
 * Odometry} says.
 *
 * <p>A fix that has nothing in common with the belief, in position or in heading, breaks one of
 * these. It is counted and not believed; but until a fix fits the belief again, the bound holds the
 * place that it tells of as well. Where fixes contradict the belief and confirm each other for
 * {@link #SETTLE_NS}, the belief was wrong (somebody carried the robot), and they replace it.
 *
 * <p>Pure: knows no port. Allocates the locations that are asked for, and a belief now and then.
 */
final class PositionFilter {

  /** So long must contradicting fixes confirm each other to be believed. */
  static final long SETTLE_NS = 30_000_000_000L;

  private final Odometry odometry = new Odometry();

  private @Nullable Belief belief;
  private long fixNs;

  // What the fixes say that contradict the belief, since the last one that fitted it.
  private @Nullable Belief rival;
  private long rivalSinceNs;

  private long contradictions;
  private long outdated;

  /** The wheels are known to be so bad, from now on; the worst that was ever stated counts. */
  void assume(double speedError, long reactionNs) {
    odometry.assume(speedError, reactionNs);
  }

  /**
   * From {@code nowNs} on the wheels are told this, while a bump sensor is closed or not; not before
   * the time of any earlier call.
   */
  void commanded(WheelCommand command, boolean bumped, long nowNs) {
    odometry.commanded(command, bumped, nowNs);
  }

  /** What the wheels may go on doing when they are told something else at {@code nowNs}. */
  Lingering lingering(long nowNs) {
    return odometry.lingering(nowNs);
  }

  boolean hasFix() {
    return belief != null;
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
    Belief known = belief;
    if (fix.timeNs() > nowNs || (known != null && fix.timeNs() < known.atNs())) {
      outdated++;
      return false;
    }
    if (known == null || !odometry.reaches(known.atNs())) {
      believe(new Belief(fix), fix);
      return true;
    }
    known.advanceTo(fix.timeNs(), odometry);
    if (known.meet(fix)) {
      believe(known, fix);
      return true;
    }
    contradictions++;
    Belief other = confirmed(fix);
    if (fix.timeNs() - rivalSinceNs >= SETTLE_NS) {
      believe(other, fix);
      return true;
    }
    return false;
  }

  private void believe(Belief newBelief, Fix fix) {
    belief = newBelief;
    fixNs = fix.timeNs();
    rival = null;
  }

  /** The rival belief, made anew if the fix contradicts this one too. */
  private Belief confirmed(Fix fix) {
    Belief other = rival;
    if (other != null && odometry.reaches(other.atNs())) {
      other.advanceTo(fix.timeNs(), odometry);
      if (other.meet(fix)) {
        return other;
      }
    }
    other = new Belief(fix);
    rival = other;
    rivalSinceNs = fix.timeNs();
    return other;
  }

  /** The belief at {@code nowNs}, which is not before the last fix or command; null without one. */
  Location.@Nullable Known at(long nowNs) {
    Belief known = belief;
    if (known == null) {
      return null;
    }
    Location.Known at = ahead(known, nowNs);
    return rival == null ? at : around(at, ahead(rival, nowNs));
  }

  private Location.Known ahead(Belief from, long nowNs) {
    odometry.locate(from.atNs(), nowNs);
    Pose pose = new Pose(from.aheadXMm(odometry), from.aheadYMm(odometry), from.aheadRad(odometry));
    double errorMm =
        odometry.reaches(from.atNs()) ? from.aheadRadiusMm(odometry) : Double.POSITIVE_INFINITY;
    return new Location.Known(pose, errorMm, from.aheadSpreadRad(odometry), nowNs, fixNs);
  }

  /** The pose of the one, with bounds that hold both. */
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
