package org.starl.apps.maze.logic;

import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.RobotType;

/** What a robot does when it bumps: the three of the paper's section 5.1. */
public enum CollisionMode {
  /** Stops at the contact; the app turns round and drives back on its trail. */
  STOP(CollisionPolicy.STOP_ON_COLLISION, 0, 5_000),
  /** Backs away from the contact, blind, for 800 ms. */
  BACK(CollisionPolicy.USE_COLBACK, 110, 5_000),
  /** Backs away, then feels along the obstacle for a while: more contacts a collision. */
  DISCOVER(CollisionPolicy.USE_COLBACK, 1_000, 4_000);

  private final CollisionPolicy policy;
  private final double wanderMm;
  private final long feelMs;

  CollisionMode(CollisionPolicy policy, double wanderMm, long feelMs) {
    this.policy = policy;
    this.wanderMm = wanderMm;
    this.feelMs = feelMs;
  }

  /** How far from its way it may get after a contact. */
  double wanderMm() {
    return wanderMm;
  }

  /** For how long it goes on after a contact on its own, at the most. */
  long feelMs() {
    return feelMs;
  }

  /** The same for a robot on its way back, which does not stay to feel for more. */
  CollisionMode goingBack() {
    return this == DISCOVER ? BACK : this;
  }

  MotionParameters applyTo(MotionParameters p) {
    RobotType type = this == DISCOVER ? RobotType.DISCOVERY : RobotType.GOAL;
    return p.toBuilder().collisionPolicy(policy).robotType(type).build();
  }
}
