package org.starl.motion;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Region;
import org.starl.geometry.RegionText;

/** The last motion command: the paper's pair {@code (target, avoid)}. */
public sealed interface MotionTask {

  /** No command yet, or the robot was stopped. */
  record None() implements MotionTask {
    @Override
    public String toString() {
      return "none";
    }
  }

  /** Go to {@code target} with the whole body outside {@code avoid}. */
  record GoTo(ItemPosition target, Region avoid) implements MotionTask {
    @Override
    public String toString() {
      return "(" + text(target) + ", " + RegionText.format(avoid) + ")";
    }
  }

  /** Turn to face {@code target}. */
  record TurnTo(ItemPosition target) implements MotionTask {
    @Override
    public String toString() {
      return "face " + text(target);
    }
  }

  /** A target as text in the trace: {@code name@x,y}. */
  static String text(ItemPosition target) {
    return target.name() + "@" + target.pose().xMm() + "," + target.pose().yMm();
  }
}
