package org.starl.primitives.paths;

/** The state of the latest {@code goTo}. */
public enum TubeFlag {
  /** There was no call yet. */
  IDLE,
  /** Planning a path, or waiting to plan again. */
  PLANNING,
  /** Requesting the tube from the others. */
  CLAIMING,
  /** Driving inside the tube. */
  MOVING,
  /** At the goal; the robot holds the disc at its place. */
  DONE,
  /** Failed; the robot stands, and keeps the parts of its tube that it has not passed. */
  FAIL
}
