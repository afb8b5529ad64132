package org.starl.body;

/** The motion automaton's reaction to a bump: the original StarL's four modes. */
public enum CollisionPolicy {
  /** Ignores the bump. */
  BUMPERCARS,
  /** Stops and fails. (The original stopped and reported an arrival.) */
  STOP_ON_COLLISION,
  /**
   * Turns away until the sensors are clear, drives straight for some time, then continues to the
   * target.
   */
  USE_COLAVOID,
  /** Backs off; the next steps depend on the {@link RobotType}. */
  USE_COLBACK;

  /** Whether the motion of a robot of type GOAL fails after a bump. */
  public boolean fails() {
    return this == STOP_ON_COLLISION || this == USE_COLBACK;
  }
}
