package org.starl.motion;

import java.util.Arrays;
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

  private static final int KNOTS = 64;

  // Contact with an object may turn the body, as if it rolled on a wheel of this radius.
  private static final double ROLLING_MM = 100;

  // These arrays grow up to KNOTS: most robots of a swarm never drive.
  private long[] atNs = {Long.MIN_VALUE};
  private double[] x = {0};
  private double[] y = {0};
  private double[] heading = {0};
  private double[] path = {0};
  private double[] stray = {0};
  private double[] turned = {0};
  private double[] linear = {0};
  private double[] angular = {0};
  private boolean[] touching = {false};
  private int newest;
  private int used = 1;

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
    int next = (newest + 1) % KNOTS;
    if (next == atNs.length) {
      grow();
    }
    atNs[next] = nowNs;
    x[next] = atX;
    y[next] = atY;
    heading[next] = atHeading;
    path[next] = atPath;
    stray[next] = atStray;
    turned[next] = atTurned;
    touching[next] = bumped;
    linear[next] = command.linearMmPerS();
    angular[next] = command.angularRadPerS();
    newest = next;
    used = Math.min(KNOTS, used + 1);
  }

  private void grow() {
    int knots = Math.min(KNOTS, 4 * atNs.length);
    atNs = Arrays.copyOf(atNs, knots);
    x = Arrays.copyOf(x, knots);
    y = Arrays.copyOf(y, knots);
    heading = Arrays.copyOf(heading, knots);
    path = Arrays.copyOf(path, knots);
    stray = Arrays.copyOf(stray, knots);
    turned = Arrays.copyOf(turned, knots);
    linear = Arrays.copyOf(linear, knots);
    angular = Arrays.copyOf(angular, knots);
    touching = Arrays.copyOf(touching, knots);
  }

  /** Whether the stored commands cover {@code timeNs}. */
  boolean reaches(long timeNs) {
    return atNs[(newest - used + 1 + KNOTS) % KNOTS] + reactionNs <= timeNs;
  }

  /** The commands that may still be in effect if a new one is given at {@code nowNs}. */
  LingeringSpeeds lingering(long nowNs) {
    if (reactionNs == 0) {
      return LingeringSpeeds.NONE;
    }
    int knot = newest;
    LingeringSpeeds all = LingeringSpeeds.NONE.with(new WheelCommand(linear[knot], angular[knot]));
    for (int i = 1; i < used && atNs[knot] + reactionNs > nowNs; i++) {
      knot = (knot - 1 + KNOTS) % KNOTS;
      all = all.with(new WheelCommand(linear[knot], angular[knot]));
    }
    return all;
  }

  /** Computes the motion between two times, relative to the pose at the first. */
  void locate(long fromNs, long toNs) {
    seek(fromNs);
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
      double cos = StrictMath.cos(fromHeading);
      double sin = StrictMath.sin(fromHeading);
      forwardMm = cos * dx + sin * dy;
      leftMm = cos * dy - sin * dx;
    }
    turnRad = atHeading - fromHeading;
    pathMm = atPath - fromPath;
    strayMm = atStray - fromStray;
    turnedRad = atTurned - fromTurned;
  }

  private void seek(long timeNs) {
    int knot = newest;
    int older = used - 1;
    while (older > 0 && atNs[knot] > timeNs) {
      knot = (knot - 1 + KNOTS) % KNOTS;
      older--;
    }
    atX = x[knot];
    atY = y[knot];
    atHeading = heading[knot];
    atPath = path[knot];
    atStray = stray[knot];
    atTurned = turned[knot];
    if (timeNs > atNs[knot]) {
      if (linear[knot] != 0 || angular[knot] != 0) {
        drive(knot, Time.seconds(timeNs - atNs[knot]));
      }
      if (reactionNs > 0) {
        linger(knot, older, timeNs);
      }
    }
  }

  private void drive(int knot, double seconds) {
    double turn = angular[knot] * seconds;
    double chord = Kinematics.chordMm(linear[knot], turn, seconds);
    if (chord != 0) {
      atX += chord * StrictMath.cos(atHeading + turn / 2);
      atY += chord * StrictMath.sin(atHeading + turn / 2);
    }
    atHeading += turn;
    atTurned += Math.abs(turn);
    double lengthMm = Math.abs(linear[knot]) * seconds;
    if (touching[knot]) {
      // The body may slide along the object in any direction, no faster than its wheels turn.
      atStray += (2 + speedError) * lengthMm;
      atTurned += (1 + speedError) * lengthMm / ROLLING_MM;
    } else {
      atPath += lengthMm;
    }
  }

  /**
   * Adds the deviation that the {@code older} commands before {@code knot} may have caused since
   * its command was given: each may be in effect until {@code reactionNs} after its successor was
   * given; the oldest ends first.
   */
  private void linger(int knot, int older, long timeNs) {
    double mmPerS = 0;
    double radPerS = 0;
    long untilNs = timeNs;
    int successor = knot;
    for (int i = 0; i < older; i++) {
      long outNs = Math.min(timeNs, atNs[successor] + reactionNs);
      if (outNs <= atNs[knot]) {
        break;
      }
      strayBy(knot, mmPerS, radPerS, untilNs - outNs);
      untilNs = outNs;
      successor = (successor - 1 + KNOTS) % KNOTS;
      mmPerS = Math.max(mmPerS, LingeringSpeeds.beyond(linear[knot], linear[successor]));
      radPerS = Math.max(radPerS, LingeringSpeeds.beyond(angular[knot], angular[successor]));
    }
    strayBy(knot, mmPerS, radPerS, untilNs - atNs[knot]);
  }

  private void strayBy(int knot, double mmPerS, double radPerS, long ns) {
    if (mmPerS == 0 && radPerS == 0) {
      return;
    }
    double most = (1 + speedError) * Time.seconds(ns);
    atStray += most * mmPerS;
    atTurned += most * (touching[knot] ? radPerS + mmPerS / ROLLING_MM : radPerS);
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
