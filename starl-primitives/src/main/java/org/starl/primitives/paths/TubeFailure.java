package org.starl.primitives.paths;

/** Why a {@code goTo} came to nothing. */
public enum TubeFailure {
  NONE,
  /** There is no path even on an empty floor, or the planner found none. */
  NO_PATH,
  /** The path has too many parts for one tube. */
  TOO_LONG,
  /** Until the deadline there was no free path, or no majority consented. */
  DEADLINE,
  /** The motion failed, or something else drove the robot. */
  MOTION,
  /** The app called {@code stop}. */
  STOPPED
}
