package org.starl.motion;

/** How the last motion command stands (paper, section 4.1: {@code motionflag}). */
public enum MotionFlag {
  /** No command was given yet, or the last one was stopped by {@code motion_stop}. */
  IDLE,
  /** On the way. */
  MOVING,
  /** Within the goal radius of the target, and stopped. */
  DONE,
  /** The motion controller cannot bring the robot to the target; it has stopped. */
  FAIL
}
