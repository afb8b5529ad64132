package org.starl.primitives.paths;

/** How the latest {@code goTo} stands. */
public enum TubeFlag {
  /** None was called yet, or it was stopped. */
  IDLE,
  /** A path is sought; or there is none at present, and it will be sought again. */
  PLANNING,
  /** The others are asked for the tube. */
  CLAIMING,
  /** On the way, inside the tube. */
  MOVING,
  /** At the goal; the robot holds the disc where it stands. */
  DONE,
  /** It came to nothing; the robot stands, and holds what it has not passed of its tube. */
  FAIL
}
