package org.starl.motion;

import org.starl.body.WheelCommand;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Sines;
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
  private static final int MAX_COMMANDS = 64;

  private static final long NEVER = Long.MIN_VALUE;

  // Contact with an object may turn the body, as if it rolled on a wheel of this radius.
  private static final double ROLLING_MM = 100;

  private final CommandLog log = new CommandLog();

  // Properties of the wheels: the worst values assumed so far.
  private double speedError;
  private long reactionNs;

  // Of the heading for which they were asked last: while the robot drives straight on, it stays the
  // same.
  private double directionRad = Double.NaN;
  private double cosine;
  private double sine;

  // The result of seek(): the ideal pose and the sums of deviations at one time.
  private long atNs = NEVER;
  private double atX;
  private double atY;
  private double atHeading;
  private double atPath;
  private double atStray;
  private double atTurned;

  // The same at the beginning of the interval that was located last.
  private long fromNs = NEVER;
  private double fromX;
  private double fromY;
  private double fromHeading;
  private double fromPath;
  private double fromStray;
  private double fromTurned;

  private double forwardMm;
  private double leftMm;

  /**
   * Assumes wheels of this quality from now on; the worst values so far count. A longer reaction
   * counts for commands that are still stored: those in effect since the last fix, and later ones.
   */
  void assume(double newSpeedError, long newReactionNs) {
    if (newSpeedError > speedError || newReactionNs > reactionNs) {
      speedError = Math.max(speedError, newSpeedError);
      reactionNs = Math.max(reactionNs, newReactionNs);
      atNs = NEVER;
      fromNs = NEVER;
    }
  }

  double speedError() {
    return speedError;
  }

  void commanded(WheelCommand command, boolean bumped, long nowNs) {
    seek(nowNs);
    log.add(nowNs, command.linearMmPerS(), command.angularRadPerS(), bumped);
    log.setState(atX, atY, atHeading, atPath, atStray, atTurned);
  }

  /** The stored commands cover the motion since this time. */
  long coveredSinceNs() {
    return log.atNs(0) + reactionNs;
  }

  /**
   * The first time that is still covered once {@link #forget} has been called. The estimates must
   * be advanced to it before.
   */
  long coveredFromNs(long nowNs) {
    if (log.size() <= MAX_COMMANDS || log.atNs(1) + reactionNs > nowNs) {
      return Long.MIN_VALUE;
    }
    return log.atNs(1) + reactionNs;
  }

  /** Forgets the oldest command. */
  void forget() {
    log.forget(1);
    // What it caused while it was in effect is in these two states, and in no other one.
    atNs = NEVER;
    fromNs = NEVER;
  }

  /** Forgets the commands that no motion since {@code timeNs} depends on. */
  void forgetBefore(long timeNs) {
    long inEffectNs = log.atNs(log.indexAt(timeNs));
    int forgotten = 0;
    while (forgotten + 1 < log.size() && log.atNs(forgotten + 1) + reactionNs <= inEffectNs) {
      forgotten++;
    }
    log.forget(forgotten);
  }

  /** The commands that may still be in effect if a new one is given at {@code nowNs}. */
  LingeringSpeeds lingering(long nowNs) {
    if (reactionNs == 0) {
      return LingeringSpeeds.NONE;
    }
    int index = log.size() - 1;
    LingeringSpeeds all = LingeringSpeeds.NONE.with(log.linear(index), log.angular(index));
    while (index > 0 && log.atNs(index) + reactionNs > nowNs) {
      index--;
      all = all.with(log.linear(index), log.angular(index));
    }
    return all;
  }

  /** Computes the motion between two times, relative to the pose at the first. */
  void locate(long beginNs, long endNs) {
    if (beginNs != fromNs) {
      seek(beginNs);
      fromNs = beginNs;
      fromX = atX;
      fromY = atY;
      fromHeading = atHeading;
      fromPath = atPath;
      fromStray = atStray;
      fromTurned = atTurned;
    }
    seek(endNs);
    double dx = atX - fromX;
    double dy = atY - fromY;
    if (dx == 0 && dy == 0) {
      forwardMm = 0;
      leftMm = 0;
    } else {
      turnTo(fromHeading);
      forwardMm = cosine * dx + sine * dy;
      leftMm = cosine * dy - sine * dx;
    }
  }

  private void turnTo(double rad) {
    if (Double.compare(rad, directionRad) != 0) {
      directionRad = rad;
      cosine = Sines.cos(rad);
      sine = Sines.sin(rad);
    }
  }

  /** Computes the state at a time. */
  private void seek(long timeNs) {
    if (timeNs == atNs) {
      return;
    }
    int index = log.indexAt(timeNs);
    atNs = timeNs;
    atX = log.x(index);
    atY = log.y(index);
    atHeading = log.heading(index);
    atPath = log.path(index);
    atStray = log.stray(index);
    atTurned = log.turned(index);
    long sinceNs = log.atNs(index);
    if (timeNs > sinceNs) {
      if (log.linear(index) != 0 || log.angular(index) != 0) {
        drive(index, Time.seconds(timeNs - sinceNs));
      }
      if (reactionNs > 0) {
        linger(index, timeNs);
      }
    }
  }

  private void drive(int index, double seconds) {
    double linear = log.linear(index);
    double turn = log.angular(index) * seconds;
    double chord = Kinematics.chordMm(linear, turn, seconds);
    if (chord != 0) {
      turnTo(atHeading + turn / 2);
      atX += chord * cosine;
      atY += chord * sine;
    }
    atHeading += turn;
    atTurned += Math.abs(turn);
    double lengthMm = Math.abs(linear) * seconds;
    if (log.isTouching(index)) {
      // The body may slide along the object in any direction, no faster than its wheels turn.
      atStray += (2 + speedError) * lengthMm;
      atTurned += (1 + speedError) * lengthMm / ROLLING_MM;
    } else {
      atPath += lengthMm;
    }
  }

  /**
   * Adds the deviation that the commands before {@code index} may have caused since its command was
   * given: each may be in effect until {@code reactionNs} after its successor was given; the oldest
   * ends first.
   */
  private void linger(int index, long timeNs) {
    double mmPerS = 0;
    double radPerS = 0;
    long untilNs = timeNs;
    long sinceNs = log.atNs(index);
    for (int old = index - 1; old >= 0; old--) {
      long outNs = Math.min(timeNs, log.atNs(old + 1) + reactionNs);
      if (outNs <= sinceNs) {
        break;
      }
      strayBy(index, mmPerS, radPerS, untilNs - outNs);
      untilNs = outNs;
      mmPerS = Math.max(mmPerS, LingeringSpeeds.beyond(log.linear(index), log.linear(old)));
      radPerS = Math.max(radPerS, LingeringSpeeds.beyond(log.angular(index), log.angular(old)));
    }
    strayBy(index, mmPerS, radPerS, untilNs - sinceNs);
  }

  private void strayBy(int index, double mmPerS, double radPerS, long ns) {
    if (mmPerS == 0 && radPerS == 0) {
      return;
    }
    double most = (1 + speedError) * Time.seconds(ns);
    atStray += most * mmPerS;
    atTurned += most * (log.isTouching(index) ? radPerS + mmPerS / ROLLING_MM : radPerS);
  }

  double forwardMm() {
    return forwardMm;
  }

  double leftMm() {
    return leftMm;
  }

  double turnRad() {
    return atHeading - fromHeading;
  }

  /** Length of the commanded path without contact. */
  double pathMm() {
    return atPath - fromPath;
  }

  /** Bound of the further deviation in any direction. */
  double strayMm() {
    return atStray - fromStray;
  }

  /** Bound of the heading deviation. */
  double turnedRad() {
    return atTurned - fromTurned;
  }
}
