package org.starl.primitives.paths;

/** Why a {@code goTo} failed. */
public enum TubeFailure {
  NONE,
  /** The planner found no path, even without the tubes of other robots. */
  NO_PATH,
  /** The path has too many parts for one tube. */
  TOO_LONG,
  /** No path was free, or no majority consented, before the deadline. */
  DEADLINE,
  /** The motion failed, or another command moved the robot. */
  MOTION,
  /** The app called {@code stop}. */
  STOPPED
}
