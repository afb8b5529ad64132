package org.starl.motion;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Region;

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
      return "(" + named(target) + ", " + avoid + ")";
    }
  }

  /** To face {@code target}. */
  record TurnTo(ItemPosition target) implements MotionTask {
    @Override
    public String toString() {
      return "face " + named(target);
    }
  }

  private static String named(ItemPosition target) {
    return target.name() + "@" + target.pose().xMm() + "," + target.pose().yMm();
  }
}
