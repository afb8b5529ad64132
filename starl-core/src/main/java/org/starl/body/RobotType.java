package org.starl.body;

/**
 * A robot's behaviour at a bump, and the paper's adversary robots. A type other than GOAL is the same
 * under every {@link CollisionPolicy}. All types run the same program and keep the contract of
 * motions: they stay outside the region to avoid, and a motion ends in DONE or FAIL within its time.
 */
public enum RobotType {
  /**
   * Reacts by its policy. Under {@link CollisionPolicy#USE_COLBACK} it backs off and fails: the app
   * decides what to do. (The original reported an arrival.)
   */
  GOAL,
  /**
   * Backs off, turns by 45 degrees, follows the obstacle on an arc, then continues to the target.
   */
  DISCOVERY,
  /**
   * Wanders: begins each motion with a turn by a random angle of up to 90 degrees and drives straight
   * for some time; with a region to avoid, such as the border of a reach tube, it only turns. After a
   * bump it backs off and wanders again; then it continues to the target.
   */
  RANDOM_MOVER
}
