package org.starl.robot.optitrack;

import static org.starl.time.Time.NS_PER_MS;
import static org.starl.time.Time.NS_PER_S;

import java.util.ArrayDeque;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.time.Time;

/**
 * Which fixes of one body are possible. A body moves at most as {@link FixBounds} says, and a robot as its
 * wheels turn ({@link WheelPath}), since each of its places on the last metres of its way; a fix beyond
 * that is a jump, whatever its time. Jumps are dropped, until poses at a new place were consistent with
 * each other, and none was at the old place, for {@link FixBounds#stillMs}: then the body was moved by
 * hand. The first place counts in the same way. A robot that has driven must also have been lifted or
 * touched; otherwise the new place contradicts its wheels, and it stands. A robot off the floor has no
 * place, so false poses that come then are no place after it was put down.
 *
 * <p>A body is not at two places at once. After {@link #LEAST_POSES} jumps, each within {@code stillMs} of
 * the one before it, no fix passes until there were no jumps for {@code stillMs}: the gate cannot know
 * which of two streams is true, since the false one may be the older one. If poses at the old place came among those at a new one,
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
    /** Too far from the fix before it, or from where the wheels have gone. */
    JUMPED,
    /** The same, and from now on no fix passes. */
    CONTRADICTED,
    /** Possible, but another stream contradicts it. */
    DOUBTED,
    /** At the first place, not for long enough yet. */
    EARLY,
    /** Of a robot off the floor. */
    LIFTED,
    /** Not newer than the fix before it. */
    OUTDATED
  }

  /** A fix, what the wheels said then, and the way that they may not have told yet. */
  private record Anchor(Fix fix, WheelPath.State wheels, double lateMm) {}

  /** Poses at a new place, and jumps that make a stream, at least. */
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

  /** Fixes are compared with these many on the way before them, at these distances. */
  private static final int MOST_ANCHORS = 32;

  private static final double ANCHORS_MM = 50;
  private static final double ANCHORS_RAD = 0.5;

  /** A robot that has gone less since its place was found has not driven. */
  private static final double STANDS_MM = 10;

  private final FixBounds bounds;
  private final ArrayDeque<Anchor> anchors = new ArrayDeque<>();
  private @Nullable Fix origin;
  private @Nullable Fix newest;
  private double placedAtMm;
  private long newPlaceFromNs = Long.MIN_VALUE;
  private int jumps;
  private long jumpedNs;

  // A possible new place: its first fix, its last, and their number.
  private @Nullable Fix first;
  private @Nullable Fix last;
  private int poses;

  PoseGate(FixBounds bounds) {
    this.bounds = bounds;
  }

  /**
   * Judges the next fix.
   *
   * @param path of this robot's wheels; null if it is not known
   */
  Verdict judge(Fix fix, @Nullable WheelPath path) {
    boolean isOld = newest != null && fix.timeNs() <= newest.timeNs();
    if (bounds.stillMs() == 0) {
      newest = isOld ? newest : fix;
      return isOld ? Verdict.OUTDATED : Verdict.PASSED;
    }
    if (path != null && path.isLifted()) {
      origin = null;
      first = null;
      last = null;
      anchors.clear();
      return Verdict.LIFTED;
    }
    WheelPath.State wheels = path == null ? null : path.at(fix.timeNs());
    if (isAtKnownPlace(fix, wheels, path)) {
      if (isOld) {
        return Verdict.OUTDATED;
      }
      boolean isDoubted = isDoubted(fix);
      keep(fix, isDoubted ? null : wheels, path);
      return isDoubted ? Verdict.DOUBTED : Verdict.PASSED;
    }
    boolean isSamePlace =
        first != null && last != null && isReachable(first, fix) && isReachable(last, fix);
    boolean isNear =
        isSamePlace && last != null && Math.abs(fix.timeNs() - last.timeNs()) <= bounds.stillNs();
    if (isNear && last != null && fix.timeNs() <= last.timeNs()) {
      return Verdict.OUTDATED;
    }
    boolean isSecondPlace = origin != null || (first != null && !isSamePlace);
    Verdict verdict = isSecondPlace ? jump(fix) : Verdict.EARLY;
    if (first == null || !isNear) {
      first = fix;
      poses = 0;
    }
    last = fix;
    poses++;
    return isNewPlace(fix, wheels, path) ? place(fix, wheels, path) : verdict;
  }

  /** The last possible fix, for a message; else the last of a first place; null if there was none. */
  @Nullable Fix before() {
    return newest == null ? last : newest;
  }

  /** Where the robot is by its wheels at the time of {@code fix}, for a message; null if unknown. */
  @Nullable Pose byWheels(Fix fix, WheelPath path) {
    WheelPath.State wheels = path.at(fix.timeNs());
    Anchor anchor = anchors.peekLast();
    return wheels == null || anchor == null || anchor.wheels.stretch() != wheels.stretch()
        ? null
        : moved(anchor, wheels);
  }

  private boolean isDoubted(Fix fix) {
    return jumps >= LEAST_POSES && fix.timeNs() - jumpedNs < bounds.stillNs();
  }

  private Verdict jump(Fix fix) {
    jumps = jumps > 0 && fix.timeNs() - jumpedNs < bounds.stillNs() ? jumps + 1 : 1;
    jumpedNs = jumps == 1 ? fix.timeNs() : Math.max(jumpedNs, fix.timeNs());
    return jumps == LEAST_POSES ? Verdict.CONTRADICTED : Verdict.JUMPED;
  }

  private void keep(Fix fix, WheelPath.@Nullable State wheels, @Nullable WheelPath path) {
    newest = fix;
    if (first != null) {
      newPlaceFromNs = fix.timeNs() + DOUBT_NS;
    }
    first = null;
    last = null;
    if (origin == null || fix.timeNs() - origin.timeNs() >= ORIGIN_NS) {
      origin = fix;
    }
    if (wheels != null && path != null && isFarFromAnchor(wheels)) {
      anchors.add(new Anchor(fix, wheels, lateMm(fix, wheels, path)));
      if (anchors.size() > MOST_ANCHORS) {
        anchors.removeFirst();
      }
    }
  }

  private boolean isFarFromAnchor(WheelPath.State wheels) {
    Anchor anchor = anchors.peekLast();
    return anchor == null
        || wheels.stretch() != anchor.wheels.stretch()
        || wheels.pathMm() - anchor.wheels.pathMm() >= ANCHORS_MM
        || wheels.turnedRad() - anchor.wheels.turnedRad() >= ANCHORS_RAD;
  }

  private boolean isNewPlace(Fix fix, WheelPath.@Nullable State wheels, @Nullable WheelPath path) {
    return first != null
        && poses >= LEAST_POSES
        && fix.timeNs() - first.timeNs() >= bounds.stillNs()
        && fix.timeNs() >= newPlaceFromNs
        && (wheels == null
            || path == null
            || wheels.pathMm() - placedAtMm < STANDS_MM
            || areWheelsThere(fix, wheels, path));
  }

  private Verdict place(Fix fix, WheelPath.@Nullable State wheels, @Nullable WheelPath path) {
    boolean isMoved = newest != null;
    first = null;
    jumps = 0;
    anchors.clear();
    placedAtMm = wheels == null ? placedAtMm : wheels.pathMm();
    origin = fix;
    keep(fix, wheels, path);
    return isMoved ? Verdict.MOVED : Verdict.PASSED;
  }

  private boolean isAtKnownPlace(
      Fix fix, WheelPath.@Nullable State wheels, @Nullable WheelPath path) {
    return origin != null
        && newest != null
        && isReachable(origin, fix)
        && isReachable(newest, fix)
        && (wheels == null || path == null || areWheelsThere(fix, wheels, path));
  }

  private boolean areWheelsThere(Fix fix, WheelPath.State wheels, WheelPath path) {
    for (Anchor anchor : anchors) {
      if (anchor.wheels.stretch() == wheels.stretch() && !isThere(fix, anchor, wheels, path)) {
        return false;
      }
    }
    return true;
  }

  private boolean isThere(Fix fix, Anchor anchor, WheelPath.State wheels, WheelPath path) {
    // Both may be late: the way between lacks one, or has the other too much.
    double lateMm = Math.max(anchor.lateMm, lateMm(fix, wheels, path));
    double lateRad = lateMm * bounds.maxTurnRadPerS() / bounds.maxSpeedMmPerS();
    double pathMm = Math.abs(wheels.pathMm() - anchor.wheels.pathMm());
    double turnsRad = path.error() * Math.abs(wheels.turnedRad() - anchor.wheels.turnedRad());
    double asideRad = Math.min(anchor.fix.errorRad(), MOST_ERROR_RAD) + turnsRad;
    return isWithin(
        moved(anchor, wheels),
        fix.pose(),
        errorMm(anchor.fix, fix) + lateMm + pathMm * (path.error() + asideRad),
        errorRad(anchor.fix, fix) + lateRad + turnsRad);
  }

  /**
   * The wheels may have turned, as commanded, for the time that their sensors are late, and at any
   * speed for the time that these are later.
   */
  private double lateMm(Fix fix, WheelPath.State wheels, WheelPath path) {
    long unknownNs = Math.min(bounds.stillNs(), fix.timeNs() - wheels.atNs() - path.lateNs());
    return (1 + path.error()) * path.fastestMmPerS() * Time.seconds(path.lateNs())
        + bounds.maxSpeedMmPerS() * Time.seconds(Math.max(0, unknownNs));
  }

  /** The pose of the anchor, moved as the wheels have turned since. */
  private static Pose moved(Anchor anchor, WheelPath.State wheels) {
    WheelPath.State then = anchor.wheels;
    double byRad = anchor.fix.pose().headingRad() - then.headingRad();
    double cosine = StrictMath.cos(byRad);
    double sine = StrictMath.sin(byRad);
    double dx = wheels.xMm() - then.xMm();
    double dy = wheels.yMm() - then.yMm();
    return new Pose(
        anchor.fix.pose().xMm() + cosine * dx - sine * dy,
        anchor.fix.pose().yMm() + sine * dx + cosine * dy,
        Angles.normalize(byRad + wheels.headingRad()));
  }

  private boolean isReachable(Fix from, Fix to) {
    // The wheels stop without fixes, so a longer gap is no longer way.
    double s = Time.seconds(Math.min(Math.abs(to.timeNs() - from.timeNs()), bounds.stillNs()));
    return isWithin(
        from.pose(),
        to.pose(),
        errorMm(from, to) + bounds.maxSpeedMmPerS() * s,
        errorRad(from, to) + bounds.maxTurnRadPerS() * s);
  }

  private static boolean isWithin(Pose one, Pose other, double mm, double rad) {
    return StrictMath.hypot(other.xMm() - one.xMm(), other.yMm() - one.yMm()) <= mm
        && Math.abs(Angles.difference(other.headingRad(), one.headingRad())) <= rad;
  }

  private double errorMm(Fix one, Fix other) {
    return error(one.errorMm(), other.errorMm(), bounds.errorFloorMm(), MOST_ERROR_MM);
  }

  private double errorRad(Fix one, Fix other) {
    return error(one.errorRad(), other.errorRad(), bounds.errorFloorRad(), MOST_ERROR_RAD);
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
