package org.starl.body;

/** Behaviour after a collision under {@link CollisionPolicy#USE_COLBACK}. */
public enum RobotType {
  /** Backs off and fails: the app decides what to do. (The original reported an arrival.) */
  GOAL,
  /**
   * Backs off, turns by 45 degrees, follows the obstacle on an arc, then continues to the target.
   */
  DISCOVERY,
  /**
   * Backs off, turns by a random angle, drives straight for some time, then continues to the
   * target.
   */
  RANDOM_MOVER
}
