package org.starl.motion;

/** State of a motion automaton. The first six are the original StarL's. */
public enum MotionState {
  INIT,
  TURN,
  STRAIGHT,
  SMALLTURN,
  ARCING,
  GOAL,
  /** Backs off after a collision. */
  COLLISION_BACK,
  /** Turns away after a collision. */
  COLLISION_TURN,
  /** Follows an obstacle on an arc. */
  COLLISION_ARC,
  /** Drives straight, away from the collision. */
  COLLISION_STRAIGHT,
  /** The motion has failed. */
  FAILED;

  /** Whether the robot reacts to a collision, away from its way. */
  boolean isManeuver() {
    return compareTo(COLLISION_BACK) >= 0 && compareTo(COLLISION_STRAIGHT) <= 0;
  }
}
