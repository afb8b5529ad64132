package org.starl.motion;

import org.starl.GlobalVarHolder;
import org.starl.GvhVariable;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Region;
import org.starl.platform.Platform;

/** {@code gvh.plat.moat}: brings the robot to a target. Strand only. */
public final class MotionControl {

  public MotionControl(GlobalVarHolder gvh, Platform platform, Gps gps) {}

  /** Goes to {@code target}, in place of whatever it did before. */
  public void doMove(ItemPosition target) {
    throw new UnsupportedOperationException();
  }

  /** Goes to {@code target} with the whole body outside {@code avoid}, or stops and says FAIL. */
  public void doMove(ItemPosition target, Region avoid) {
    throw new UnsupportedOperationException();
  }

  public boolean inMotion() {
    throw new UnsupportedOperationException();
  }

  public void motion_stop() {
    throw new UnsupportedOperationException();
  }

  public GvhVariable<MotionFlag> motionflag() {
    throw new UnsupportedOperationException();
  }
}
