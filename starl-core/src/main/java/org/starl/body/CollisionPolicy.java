package org.starl.body;

/** What the motion automaton does when a bump sensor closes; the original StarL's four modes. */
public enum CollisionPolicy {
  /** Drives on as if nothing had happened. */
  BUMPERCARS,
  /** Stops and fails. (The original stopped and said that it had arrived.) */
  STOP_ON_COLLISION,
  /** Turns away until the sensors are clear, drives straight for a while, goes on to its target. */
  USE_COLAVOID,
  /** Backs off; what follows depends on the {@link RobotType}. */
  USE_COLBACK
}
