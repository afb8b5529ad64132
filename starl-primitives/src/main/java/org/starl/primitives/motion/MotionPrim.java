package org.starl.primitives.motion;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Region;
import org.starl.gvh.GvhVariable;
import org.starl.motion.MotionFlag;
import org.starl.motion.MotionTask;
import org.starl.primitives.StarLPrimitive;

/**
 * Motion control as an app sees it (paper, section 4.1, and the second listing of section 2): to a
 * target, outside a region. Millimetres, in the coordinates of the positioning system. Strand only.
 *
 * <pre>{@code
 * mc.do_move(t, A);
 * await(() -> mc.motionflag().get() != MotionFlag.MOVING);
 * if (mc.motionflag().get() == MotionFlag.DONE) {
 *   // near t
 * }
 * }</pre>
 */
public interface MotionPrim extends StarLPrimitive {

  /** Goes to {@code target}, whatever is in the way; in place of what it did before. */
  void gotopoint(ItemPosition target);

  /**
   * Goes to {@code target} with the whole body outside {@code avoid}, in place of what it did
   * before. A target at which the body would touch {@code avoid} fails at once; {@code avoid} in
   * the way stops the robot and fails: going round it is a planner's. The target's heading is of no
   * account.
   */
  void do_move(ItemPosition target, Region avoid);

  /** The pair {@code (target, avoid)}: what the robot was told to do last. */
  GvhVariable<MotionTask> target();

  /** How the last motion stands. */
  GvhVariable<MotionFlag> motionflag();

  /** Whether it failed. */
  boolean failed();

  /** Why it failed, in words for people; empty unless it did. */
  String failure();

  /** Stops the wheels and forgets the target: {@code motionflag} is IDLE. */
  void motion_stop();
}
