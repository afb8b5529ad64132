package org.starl.motion;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.body.WheelCommand;
import org.starl.geometry.Kinematics;
import org.starl.time.Time;

/**
 * Dead reckoning from the commands: the pose of an ideal body in a frame of its own, and bounds of
 * a true body's deviation. Stores the last commands, because a fix refers to the past.
 *
 * <p>Model of a true body: at any time it follows one of the commands that may be in effect, at
 * between 0 (blocked) and {@code 1 + speedError} times its speed, driving and turning
 * independently. A command is certainly in effect from {@code reactionNs} after it was given until
 * the next one is given; commands take effect in their order.
 */
final class Odometry {

  /** It forgets older commands, unless they may still be in effect. */
  private static final int MAX_KNOTS = 64;

  // Contact with an object may turn the body, as if it rolled on a wheel of this radius.
  private static final double ROLLING_MM = 100;

  /** A command, with the ideal pose and the sums of deviations at its time. */
  private static final class Knot {
    final long atNs;
    final double linear;
    final double angular;
    final boolean touching;
    double x;
    double y;
    double heading;
    double path;
    double stray;
    double turned;
    @Nullable Knot older;
    @Nullable Knot newer;

    // Of the heading, once asked for: while the robot drives straight on, it stays the same.
    private double cosine = Double.NaN;
    private double sine;

    Knot(long atNs, WheelCommand command, boolean touching) {
      this.atNs = atNs;
      this.linear = command.linearMmPerS();
      this.angular = command.angularRadPerS();
      this.touching = touching;
    }

    /** The cosine of {@code rad}. Computes it once for {@link #heading}. */
    double cos(double rad) {
      if (Double.compare(rad, heading) != 0) {
        return StrictMath.cos(rad);
      }
      if (Double.isNaN(cosine)) {
        cosine = StrictMath.cos(heading);
        sine = StrictMath.sin(heading);
      }
      return cosine;
    }

    /** The sine of {@code rad}; call {@link #cos} before. */
    double sin(double rad) {
      return Double.compare(rad, heading) == 0 ? sine : StrictMath.sin(rad);
    }
  }

  private Knot newest = new Knot(Long.MIN_VALUE, WheelCommand.STOP, false);
  private Knot oldest = newest;
  private int knots = 1;

  // Properties of the wheels: the worst values ever assumed.
  private double speedError;
  private long reactionNs;

  private double forwardMm;
  private double leftMm;
  private double turnRad;
  private double pathMm;
  private double strayMm;
  private double turnedRad;

  // The result of seek().
  private double atX;
  private double atY;
  private double atHeading;
  private double atPath;
  private double atStray;
  private double atTurned;

  /** Assumes wheels of this quality from now on; the worst values so far count. */
  void assume(double newSpeedError, long newReactionNs) {
    speedError = Math.max(speedError, newSpeedError);
    reactionNs = Math.max(reactionNs, newReactionNs);
  }

  double speedError() {
    return speedError;
  }

  void commanded(WheelCommand command, boolean bumped, long nowNs) {
    seek(nowNs);
    Knot knot = new Knot(nowNs, command, bumped);
    knot.x = atX;
    knot.y = atY;
    knot.heading = atHeading;
    knot.path = atPath;
    knot.stray = atStray;
    knot.turned = atTurned;
    knot.older = newest;
    newest.newer = knot;
    newest = knot;
    knots++;
  }

  /** The stored commands cover the motion since this time. */
  long coveredSinceNs() {
    return oldest.atNs + reactionNs;
  }

  /**
   * The first time that is still covered once {@link #forget} has been called. The estimates must
   * be advanced to it before.
   */
  long coveredFromNs(long nowNs) {
    Knot second = oldest.newer;
    if (knots <= MAX_KNOTS || second == null || second.atNs + reactionNs > nowNs) {
      return Long.MIN_VALUE;
    }
    return second.atNs + reactionNs;
  }

  /** Forgets the oldest command. */
  void forget() {
    oldest = Objects.requireNonNull(oldest.newer);
    oldest.older = null;
    knots--;
  }

  /** The commands that may still be in effect if a new one is given at {@code nowNs}. */
  LingeringSpeeds lingering(long nowNs) {
    if (reactionNs == 0) {
      return LingeringSpeeds.NONE;
    }
    Knot knot = newest;
    LingeringSpeeds all = LingeringSpeeds.NONE.with(knot.linear, knot.angular);
    while (knot.older != null && knot.atNs + reactionNs > nowNs) {
      knot = knot.older;
      all = all.with(knot.linear, knot.angular);
    }
    return all;
  }

  /** Computes the motion between two times, relative to the pose at the first. */
  void locate(long fromNs, long toNs) {
    Knot from = seek(fromNs);
    double fromX = atX;
    double fromY = atY;
    double fromHeading = atHeading;
    double fromPath = atPath;
    double fromStray = atStray;
    double fromTurned = atTurned;
    seek(toNs);
    double dx = atX - fromX;
    double dy = atY - fromY;
    if (dx == 0 && dy == 0) {
      forwardMm = 0;
      leftMm = 0;
    } else {
      double cos = from.cos(fromHeading);
      double sin = from.sin(fromHeading);
      forwardMm = cos * dx + sin * dy;
      leftMm = cos * dy - sin * dx;
    }
    turnRad = atHeading - fromHeading;
    pathMm = atPath - fromPath;
    strayMm = atStray - fromStray;
    turnedRad = atTurned - fromTurned;
  }

  /** Returns the command at that time, the latest one. */
  private Knot seek(long timeNs) {
    Knot knot = newest;
    while (knot.older != null && knot.atNs > timeNs) {
      knot = knot.older;
    }
    atX = knot.x;
    atY = knot.y;
    atHeading = knot.heading;
    atPath = knot.path;
    atStray = knot.stray;
    atTurned = knot.turned;
    if (timeNs > knot.atNs) {
      if (knot.linear != 0 || knot.angular != 0) {
        drive(knot, Time.seconds(timeNs - knot.atNs));
      }
      if (reactionNs > 0) {
        linger(knot, timeNs);
      }
    }
    return knot;
  }

  private void drive(Knot knot, double seconds) {
    double turn = knot.angular * seconds;
    double chord = Kinematics.chordMm(knot.linear, turn, seconds);
    if (chord != 0) {
      atX += chord * knot.cos(atHeading + turn / 2);
      atY += chord * knot.sin(atHeading + turn / 2);
    }
    atHeading += turn;
    atTurned += Math.abs(turn);
    double lengthMm = Math.abs(knot.linear) * seconds;
    if (knot.touching) {
      // The body may slide along the object in any direction, no faster than its wheels turn.
      atStray += (2 + speedError) * lengthMm;
      atTurned += (1 + speedError) * lengthMm / ROLLING_MM;
    } else {
      atPath += lengthMm;
    }
  }

  /**
   * Adds the deviation that the commands before {@code knot} may have caused since its command was
   * given: each may be in effect until {@code reactionNs} after its successor was given; the oldest
   * ends first.
   */
  private void linger(Knot knot, long timeNs) {
    double mmPerS = 0;
    double radPerS = 0;
    long untilNs = timeNs;
    long successorNs = knot.atNs;
    for (Knot old = knot.older; old != null; old = old.older) {
      long outNs = Math.min(timeNs, successorNs + reactionNs);
      if (outNs <= knot.atNs) {
        break;
      }
      strayBy(knot, mmPerS, radPerS, untilNs - outNs);
      untilNs = outNs;
      successorNs = old.atNs;
      mmPerS = Math.max(mmPerS, LingeringSpeeds.beyond(knot.linear, old.linear));
      radPerS = Math.max(radPerS, LingeringSpeeds.beyond(knot.angular, old.angular));
    }
    strayBy(knot, mmPerS, radPerS, untilNs - knot.atNs);
  }

  private void strayBy(Knot knot, double mmPerS, double radPerS, long ns) {
    if (mmPerS == 0 && radPerS == 0) {
      return;
    }
    double most = (1 + speedError) * Time.seconds(ns);
    atStray += most * mmPerS;
    atTurned += most * (knot.touching ? radPerS + mmPerS / ROLLING_MM : radPerS);
  }

  double forwardMm() {
    return forwardMm;
  }

  double leftMm() {
    return leftMm;
  }

  double turnRad() {
    return turnRad;
  }

  /** Length of the commanded path without contact. */
  double pathMm() {
    return pathMm;
  }

  /** Bound of the further deviation in any direction. */
  double strayMm() {
    return strayMm;
  }

  /** Bound of the heading deviation. */
  double turnedRad() {
    return turnedRad;
  }
}
