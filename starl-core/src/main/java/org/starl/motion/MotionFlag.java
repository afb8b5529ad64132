package org.starl.motion;

/** State of the last motion command (paper, section 4.1: {@code motionflag}). */
public enum MotionFlag {
  /** No command yet, or the last one was stopped by {@code motion_stop}. */
  IDLE,
  /** The motion is going on. */
  MOVING,
  /** Stopped within the goal radius of the target. */
  DONE,
  /** The robot cannot reach the target; it has stopped. */
  FAIL
}
