package org.starl.primitives.motion;

import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;

/** One command to move, as {@link MotionBodies} follows it. */
final class MotionRecord {

  /** From 1 on, of all commands of a run. */
  final long number;

  final RobotId robot;
  final Point target;
  final Region avoid;
  final boolean turnsOnly;
  final long startNs;

  /** Until then its flag must tell how it ended. */
  long deadlineNs;

  /** Whether its flag has not told yet. */
  boolean isOpen = true;

  /** Whether the body was outside at first, and has been since. */
  boolean owesAvoids;

  boolean owesArrives;

  /** The body was followed until then. */
  long followedNs;

  /** Where the robot said that it was when it arrived, and how certain that was. */
  Point saidAt = new Point(Double.NaN, Double.NaN);

  double saidErrorMm;

  MotionRecord(
      long number, RobotId robot, Point target, Region avoid, boolean turnsOnly, long startNs) {
    this.number = number;
    this.robot = robot;
    this.target = target;
    this.avoid = avoid;
    this.turnsOnly = turnsOnly;
    this.startNs = startNs;
    this.followedNs = startNs;
  }
}
