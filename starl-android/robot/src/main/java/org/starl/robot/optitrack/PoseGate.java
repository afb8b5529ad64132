package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_MS;
import static org.starl.time.Time.NS_PER_S;

import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.time.Time;

/**
 * Which fixes of one body are possible. A body moves at most as {@link FixBounds} says; a fix beyond
 * that is a jump. Jumps are dropped, until poses at a new place were consistent with each other, and
 * none was at the old place, for {@link FixBounds#stillMs}: then the body was moved by hand. The
 * first place counts in the same way. So single false datagrams do not move a body; a robot that is
 * really moved by hand has no fixes for that time, and stands.
 *
 * <p>A body is not at two places at once. If poses at the old place came among those at a new one,
 * somebody sends false ones. Then a new place counts only after {@link #DOUBT_NS} without the old
 * one, so false poses do not move a body when the true ones fail for a short time.
 *
 * <p>Pure; one thread at a time.
 */
final class PoseGate {

  /** What a fix is. */
  enum Verdict {
    /** Possible. */
    PASSED,
    /** Possible, at a new place: moved by hand. */
    MOVED,
    /** Too far from the fix before it. */
    JUMPED,
    /** At the first place, not for long enough yet. */
    EARLY,
    /** Not newer than the fix before it. */
    OUTDATED
  }

  /** Poses at a new place, at least. */
  static final int LEAST_POSES = 3;

  /** A sender's claim of a larger error does not make a jump possible. */
  static final double MOST_ERROR_MM = 100;

  static final double MOST_ERROR_RAD = 0.3;

  /**
   * Fixes are compared with one of this age or newer: with each single one as the origin of the next,
   * the errors of many false ones in a row would add up to any distance.
   */
  private static final long ORIGIN_NS = 100 * NS_PER_MS;

  /** No new place counts for this time after a pose at the old place came among those at a new one. */
  static final long DOUBT_NS = 10 * NS_PER_S;

  private final FixBounds bounds;
  private @Nullable Fix origin;
  private long newestNs = Long.MIN_VALUE;
  private long doubtUntilNs = Long.MIN_VALUE;

  // A possible new place: its first fix, its last, and their number.
  private @Nullable Fix first;
  private @Nullable Fix last;
  private int poses;

  PoseGate(FixBounds bounds) {
    this.bounds = bounds;
  }

  /** Judges the next fix. */
  Verdict judge(Fix fix) {
    if (fix.timeNs() <= newestNs) {
      return Verdict.OUTDATED;
    }
    if (bounds.stillMs() == 0 || (origin != null && isReachable(origin, fix))) {
      return pass(fix);
    }
    if (last != null && fix.timeNs() <= last.timeNs()) {
      return Verdict.OUTDATED;
    }
    boolean isConsistent =
        last != null && fix.timeNs() - last.timeNs() <= bounds.stillNs() && isReachable(last, fix);
    boolean isBroken = first != null && !isConsistent;
    if (first == null || !isConsistent) {
      first = fix;
      poses = 0;
    }
    last = fix;
    poses++;
    if (poses >= LEAST_POSES
        && fix.timeNs() - first.timeNs() >= bounds.stillNs()
        && fix.timeNs() >= doubtUntilNs) {
      boolean isMoved = origin != null;
      origin = fix;
      first = null;
      pass(fix);
      return isMoved ? Verdict.MOVED : Verdict.PASSED;
    }
    return origin == null && !isBroken ? Verdict.EARLY : Verdict.JUMPED;
  }

  /** The last possible fix, for a message; null if there was none. */
  @Nullable Fix before() {
    return origin;
  }

  private Verdict pass(Fix fix) {
    newestNs = fix.timeNs();
    if (first != null) {
      doubtUntilNs = fix.timeNs() + DOUBT_NS;
    }
    first = null;
    last = null;
    if (origin == null || fix.timeNs() - origin.timeNs() >= ORIGIN_NS) {
      origin = fix;
    }
    return Verdict.PASSED;
  }

  private boolean isReachable(Fix from, Fix to) {
    // The wheels stop without fixes, so a longer gap is no longer way.
    double s = Time.seconds(Math.min(to.timeNs() - from.timeNs(), bounds.stillNs()));
    double errorMm = error(from.errorMm(), to.errorMm(), bounds.errorFloorMm(), MOST_ERROR_MM);
    double errorRad = error(from.errorRad(), to.errorRad(), bounds.errorFloorRad(), MOST_ERROR_RAD);
    double goneMm =
        StrictMath.hypot(to.pose().xMm() - from.pose().xMm(), to.pose().yMm() - from.pose().yMm());
    double turnedRad =
        Math.abs(Angles.difference(to.pose().headingRad(), from.pose().headingRad()));
    return goneMm <= errorMm + bounds.maxSpeedMmPerS() * s
        && turnedRad <= errorRad + bounds.maxTurnRadPerS() * s;
  }

  private static double error(double one, double other, double floor, double cap) {
    double most = Math.max(floor, cap);
    return Math.min(one, most) + Math.min(other, most);
  }

  /** A pose as text, for messages. */
  static String text(Pose pose) {
    return String.format(
        Locale.ROOT, "(%.0f mm, %.0f mm, %.2f rad)", pose.xMm(), pose.yMm(), pose.headingRad());
  }
}
