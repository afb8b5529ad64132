package org.starl.robot.create;

/** Why the driver holds the wheels, wholly or, where it says so, in part. */
public enum CreateHold {
  /** {@link CreateChassis#emergencyStop} was called, and nobody took it back. */
  EMERGENCY_STOP,
  /** There is no link to the robot. It does what it was told last. */
  NO_LINK,
  /** The link is open, and the robot's sensors are not heard. */
  NO_SENSORS,
  /** The robot is not, or no longer, in the mode in which it is driven. */
  NOT_IN_MODE,
  /** A wheel hangs down. */
  WHEEL_DROP,
  /** A bump sensor has closed, and the program does not know yet. */
  BUMP_UNTOLD,
  /** The program has not repeated its command for too long. */
  STALE_COMMAND,
  /** The last fix is too old, or there was none. */
  STALE_POSITION,
  /** A cliff is seen: only straight back. */
  CLIFF,
  /** A bump sensor is closed: turning and backward, not forward. */
  BUMP;

  /** Whether the wheels may not turn at all. */
  public boolean isWhole() {
    return this != CLIFF && this != BUMP;
  }
}
