package org.starl.primitives.motion;

import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;

/** One motion command, as {@link MotionBodies} follows it. */
final class MotionRecord {

  /** Counts the commands of all robots in a run, from 1. */
  final long number;

  final RobotId robot;
  final Point target;
  final Region avoid;
  final boolean turnsOnly;
  final long startNs;

  /** When the body could begin to drive: from then on it may not stand too long. */
  long triesFromNs;

  /** The time until which {@code motionflag} must report the result. */
  long deadlineNs;

  /** Before this time it has not taken longer than the longest time for its way. */
  long slowFromNs;

  /** Whether {@code motionflag} has not reported the result yet. */
  boolean isOpen = true;

  /** Whether the body was outside at the start, and has not entered since. */
  boolean owesAvoids;

  boolean owesArrives;

  /** Whether no fault has changed the robot's clock since the command. */
  boolean hasTrueClock;

  /** Whether no fault has been active since the command. */
  boolean isCalm;

  /** Whether the body has driven backwards. */
  boolean hasBackedOff;

  /** The time until which the body was followed. */
  long followedNs;

  /** The robot's estimated position and error bound when it reported its arrival. */
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
    this.triesFromNs = startNs;
    this.followedNs = startNs;
  }
}
