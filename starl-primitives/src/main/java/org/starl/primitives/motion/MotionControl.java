package org.starl.primitives.motion;

import org.starl.GlobalVarHolder;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Region;
import org.starl.geometry.RegionText;
import org.starl.gvh.GvhVariable;
import org.starl.motion.MotionController;
import org.starl.motion.MotionFlag;
import org.starl.motion.MotionTask;

/**
 * The paper's <i>Motioncontrol</i>, under the names of its section 4.1, over the motion automaton
 * {@code gvh.plat.moat}. All instances on a robot share its body, and the last command counts. The
 * package documentation is the contract. Strand only.
 */
public final class MotionControl implements MotionPrim {

  private final GlobalVarHolder gvh;
  private final MotionController moat;

  public MotionControl(GlobalVarHolder gvh) {
    this.gvh = gvh;
    moat = gvh.plat.moat;
  }

  @Override
  public void gotopoint(ItemPosition target) {
    gvh.trace.action(MotionTrace.SOURCE, MotionTrace.GOTOPOINT, MotionTask.text(target));
    moat.doMove(target, new Nowhere());
  }

  @Override
  public void do_move(ItemPosition target, Region avoid) {
    if (gvh.trace.isOn()) {
      gvh.trace.action(
          MotionTrace.SOURCE,
          MotionTrace.DO_MOVE,
          MotionTask.text(target),
          RegionText.format(avoid));
    }
    moat.doMove(target, avoid);
  }

  @Override
  public GvhVariable<MotionTask> target() {
    return moat.target();
  }

  @Override
  public GvhVariable<MotionFlag> motionflag() {
    return moat.motionflag();
  }

  @Override
  public boolean failed() {
    return moat.failed();
  }

  @Override
  public String failure() {
    return moat.failure();
  }

  @Override
  public void motion_stop() {
    moat.motion_stop();
  }

  @Override
  public String source() {
    return MotionTrace.SOURCE;
  }

  @Override
  public void close() {
    motion_stop();
  }
}
