package org.starl.primitives.motion;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Region;
import org.starl.gvh.GvhVariable;
import org.starl.motion.MotionFlag;
import org.starl.motion.MotionTask;
import org.starl.primitives.StarLPrimitive;

/**
 * The interface of motion control (paper, section 4.1, and the second listing of section 2): motion
 * to a target, outside a region. Lengths are in mm, in the coordinates of the positioning system.
 * Strand only.
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

  /** The paper's name in section 4.1 for {@link #do_move}. */
  void gotopoint(ItemPosition target, Region avoid);

  /** Goes to {@code target} without a region to avoid. */
  default void gotopoint(ItemPosition target) {
    gotopoint(target, new Nowhere());
  }

  /**
   * Goes to {@code target} with the whole body outside {@code avoid}. Replaces the last command. If
   * the body would touch {@code avoid} at the target, the motion fails at once. If {@code avoid} or a
   * known obstacle is on the way, the robot plans a way around them, beside the strand, and drives on
   * it; if there is none with room for the body, its position error and a third of the goal radius,
   * the motion fails. A way is planned from what is known at the call, and anew where {@code avoid}
   * turns out to be in the way. The target's heading is ignored.
   */
  void do_move(ItemPosition target, Region avoid);

  /** The pair {@code (target, avoid)} of the last command. */
  GvhVariable<MotionTask> target();

  /** The state of the last motion. */
  GvhVariable<MotionFlag> motionflag();

  /** Whether the last motion failed. */
  boolean failed();

  /** Why the last motion failed, as readable text; empty if it did not fail. */
  String failure();

  /** Stops the wheels and cancels the last command: {@code motionflag} is IDLE. */
  void motion_stop();
}
