package org.starl.motion;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Region;
import org.starl.geometry.RegionText;

/** What the robot was told to do last: the paper's pair {@code (target, avoid)}. */
public sealed interface MotionTask {

  /** Nothing yet, or to stop. */
  record None() implements MotionTask {
    @Override
    public String toString() {
      return "none";
    }
  }

  /** To go to {@code target} with the whole body outside {@code avoid}. */
  record GoTo(ItemPosition target, Region avoid) implements MotionTask {
    @Override
    public String toString() {
      return "(" + text(target) + ", " + RegionText.format(avoid) + ")";
    }
  }

  /** To face {@code target}. */
  record TurnTo(ItemPosition target) implements MotionTask {
    @Override
    public String toString() {
      return "face " + text(target);
    }
  }

  /** A target as the trace writes it: {@code name@x,y}. */
  static String text(ItemPosition target) {
    return target.name() + "@" + target.pose().xMm() + "," + target.pose().yMm();
  }
}
