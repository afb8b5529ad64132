package org.starl.apps.maze.logic;

import org.starl.body.CollisionPolicy;
import org.starl.body.RobotType;

/** A robot's reaction to a bump: the three modes of the paper's section 5.1. */
public enum CollisionMode {
  /** Stops at the contact; the app turns round and drives back on its trail. */
  STOP(CollisionPolicy.STOP_ON_COLLISION, 0, 5_000),
  /** Backs away from the contact for 800 ms. */
  BACK(CollisionPolicy.USE_COLBACK, 110, 5_000),
  /** Backs away, then drives along the obstacle for a while, which gives more contacts. */
  DISCOVER(CollisionPolicy.USE_COLBACK, 1_000, 4_000);

  private final CollisionPolicy policy;
  private final double wanderMm;
  private final long feelMs;

  CollisionMode(CollisionPolicy policy, double wanderMm, long feelMs) {
    this.policy = policy;
    this.wanderMm = wanderMm;
    this.feelMs = feelMs;
  }

  /** How far from its way the robot may get after a contact. */
  public double wanderMm() {
    return wanderMm;
  }

  /** For how long it moves by itself after a contact, at most. */
  long feelMs() {
    return feelMs;
  }

  /** The mode of a robot on its way back, which does not look for more contacts. */
  CollisionMode goingBack() {
    return this == DISCOVER ? BACK : this;
  }

  CollisionPolicy policy() {
    return policy;
  }

  RobotType robotType() {
    return this == DISCOVER ? RobotType.DISCOVERY : RobotType.GOAL;
  }
}
