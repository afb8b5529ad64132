package org.starl.body;

/** How a robot behaves after a collision under {@link CollisionPolicy#USE_COLBACK}. */
public enum RobotType {
  /** Backs off and fails: its app decides how to go on. (The original reported an arrival.) */
  GOAL,
  /** Backs off, turns by 45 degrees, follows the obstacle on an arc, goes on to its target. */
  DISCOVERY,
  /** Backs off, turns at random, drives straight for a while, goes on to its target. */
  RANDOM_MOVER
}
