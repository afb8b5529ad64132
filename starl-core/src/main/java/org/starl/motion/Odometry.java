package org.starl.motion;

import java.util.Arrays;
import org.starl.body.WheelCommand;
import org.starl.geometry.Kinematics;
import org.starl.time.Time;

/**
 * What the commands would have done to a body that follows them: a pose in a frame of its own, and
 * how far a true body may have come off. Remembers the last commands, because a fix tells of the
 * past.
 *
 * <p>What is known of a true body: at any time it follows one of the commands that may be in effect,
 * from none of it (held up) to {@code 1 + speedError} times of it, driving and turning each on its
 * own. A command is in effect for certain from {@code reactionNs} after it was given, until the next
 * one is given; commands take effect in their order.
 */
final class Odometry {

  private static final int KNOTS = 64;

  // The contact with what a body touches may turn it, as if it rolled on so small a wheel.
  private static final double ROLLING_MM = 100;

  // These grow up to KNOTS: most robots of a swarm never drive.
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

  // Properties of the wheels: the worst that was ever stated.
  private double speedError;
  private long reactionNs;

  private double forwardMm;
  private double leftMm;
  private double turnRad;
  private double pathMm;
  private double strayMm;
  private double turnedRad;

  // The pose that seek() has found.
  private double atX;
  private double atY;
  private double atHeading;
  private double atPath;
  private double atStray;
  private double atTurned;

  /** The wheels are known to be so bad, from now on. */
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

  /** Whether it still knows what was in effect at {@code timeNs}. */
  boolean reaches(long timeNs) {
    return atNs[(newest - used + 1 + KNOTS) % KNOTS] + reactionNs <= timeNs;
  }

  /** What the wheels may go on doing when they are told something else at {@code nowNs}. */
  Lingering lingering(long nowNs) {
    if (reactionNs == 0) {
      return Lingering.NONE;
    }
    int knot = newest;
    Lingering all = Lingering.NONE.with(new WheelCommand(linear[knot], angular[knot]));
    for (int i = 1; i < used && atNs[knot] + reactionNs > nowNs; i++) {
      knot = (knot - 1 + KNOTS) % KNOTS;
      all = all.with(new WheelCommand(linear[knot], angular[knot]));
    }
    return all;
  }

  /** Finds the motion from one time to a later one, seen from the pose at the first. */
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
      // It may slide along what it touches, whatever way, no faster than its wheels turn.
      atStray += (2 + speedError) * lengthMm;
      atTurned += (1 + speedError) * lengthMm / ROLLING_MM;
    } else {
      atPath += lengthMm;
    }
  }

  /**
   * Adds what the {@code older} commands before {@code knot}'s may have done beyond it since it was
   * given: each is out of effect {@code reactionNs} after its successor was given, the oldest first.
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
      mmPerS = Math.max(mmPerS, Lingering.beyond(linear[knot], linear[successor]));
      radPerS = Math.max(radPerS, Lingering.beyond(angular[knot], angular[successor]));
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

  /** Length of the commanded path, where nothing was touched. */
  double pathMm() {
    return pathMm;
  }

  /** A body may be off by so much more, whatever way. */
  double strayMm() {
    return strayMm;
  }

  /** A body's heading may be off by so much. */
  double turnedRad() {
    return turnedRad;
  }
}
