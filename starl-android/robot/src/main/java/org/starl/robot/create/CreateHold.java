package org.starl.robot.create;

/** Reasons for which the driver stops the wheels; {@link #CLIFF} and {@link #BUMP} only limit them. */
public enum CreateHold {
  /** {@link CreateChassis#emergencyStop} was called and not released. */
  EMERGENCY_STOP,
  /** There is no link to the robot, which continues its last command. */
  NO_LINK,
  /** The link is open, but no sensor frames arrive. */
  NO_SENSORS,
  /** The robot is not in the mode of the settings. */
  NOT_IN_MODE,
  /** A wheel hangs down. */
  WHEEL_DROP,
  /** A bump sensor has closed, and the program has not been informed yet. */
  BUMP_UNTOLD,
  /** The program has not repeated its command for too long. */
  STALE_COMMAND,
  /** The last fix is too old, or there is none. */
  STALE_POSITION,
  /** A cliff is seen: only straight backward is allowed. */
  CLIFF,
  /** A bump sensor is closed: turning and backward are allowed, forward is not. */
  BUMP;

  /** Whether it stops the wheels completely. */
  public boolean isWhole() {
    return this != CLIFF && this != BUMP;
  }
}
