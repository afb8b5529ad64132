package org.starl.motion;

import java.util.Arrays;
import org.starl.geometry.Kinematics;

/**
 * What the commands would have done to a body that follows them: a pose in a frame of its own,
 * with the path and the turns summed up. Remembers the last commands, because a fix tells of the
 * past.
 */
final class Odometry {

  private static final double NS_PER_S = 1e9;
  private static final int KNOTS = 64;

  // A body that touches something may slide along it, no faster than its wheels turn and whatever
  // way: from where the command leads, at most twice the path. The contact may turn it, as if it
  // rolled on so small a wheel.
  private static final double SLIDING = 2;
  private static final double ROLLING_MM = 100;

  // These grow up to KNOTS: most robots of a swarm never drive.
  private long[] atNs = {Long.MIN_VALUE};
  private double[] x = {0};
  private double[] y = {0};
  private double[] heading = {0};
  private double[] path = {0};
  private double[] turned = {0};
  private double[] linear = {0};
  private double[] angular = {0};
  private boolean[] touching = {false};
  private int newest;
  private int used = 1;

  private double forwardMm;
  private double leftMm;
  private double turnRad;
  private double pathMm;
  private double turnedRad;

  // The pose that seek() has found.
  private double atX;
  private double atY;
  private double atHeading;
  private double atPath;
  private double atTurned;

  void commanded(WheelCommand command, boolean bumped, double reactionS, long nowNs) {
    seek(nowNs);
    double lateMm = Math.abs(command.linearMmPerS() - linear[newest]) * reactionS;
    double lateRad = Math.abs(command.angularRadPerS() - angular[newest]) * reactionS;
    int next = (newest + 1) % KNOTS;
    if (next == atNs.length) {
      grow();
    }
    atNs[next] = nowNs;
    x[next] = atX;
    y[next] = atY;
    heading[next] = atHeading;
    path[next] = atPath + lateMm;
    turned[next] = atTurned + lateRad;
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
    turned = Arrays.copyOf(turned, knots);
    linear = Arrays.copyOf(linear, knots);
    angular = Arrays.copyOf(angular, knots);
    touching = Arrays.copyOf(touching, knots);
  }

  /** Whether it still knows what was commanded at {@code timeNs}. */
  boolean reaches(long timeNs) {
    return atNs[(newest - used + 1 + KNOTS) % KNOTS] <= timeNs;
  }

  /** Finds the motion from one time to a later one, seen from the pose at the first. */
  void locate(long fromNs, long toNs) {
    seek(fromNs);
    double fromX = atX;
    double fromY = atY;
    double fromHeading = atHeading;
    double fromPath = atPath;
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
    turnedRad = atTurned - fromTurned;
  }

  private void seek(long timeNs) {
    int knot = newest;
    for (int i = 1; i < used && atNs[knot] > timeNs; i++) {
      knot = (knot - 1 + KNOTS) % KNOTS;
    }
    atX = x[knot];
    atY = y[knot];
    atHeading = heading[knot];
    atPath = path[knot];
    atTurned = turned[knot];
    boolean moves = linear[knot] != 0 || angular[knot] != 0;
    if (moves && timeNs > atNs[knot]) {
      drive(knot, (timeNs - atNs[knot]) / NS_PER_S);
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
    double pathMm = Math.abs(linear[knot]) * seconds;
    atPath += touching[knot] ? SLIDING * pathMm : pathMm;
    atTurned += Math.abs(turn) + (touching[knot] ? pathMm / ROLLING_MM : 0);
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

  double pathMm() {
    return pathMm;
  }

  double turnedRad() {
    return turnedRad;
  }
}
