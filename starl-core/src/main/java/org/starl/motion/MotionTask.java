package org.starl.motion;

import static org.starl.shape.Shapes.part;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Region;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

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
      return "(" + target + ", " + avoid + ")";
    }
  }

  /** Turn to face {@code target}. */
  record TurnTo(ItemPosition target) implements MotionTask {
    @Override
    public String toString() {
      return "face " + target;
    }
  }

  /** Its shape. */
  Shape<MotionTask> SHAPE =
      Shapes.oneOf(
          MotionTask.class,
          Shapes.of(None.class, None::new),
          Shapes.of(
              GoTo.class,
              part("target", Geometry.ITEM, GoTo::target),
              part("avoid", Geometry.REGION, GoTo::avoid),
              GoTo::new),
          Shapes.of(TurnTo.class, part("target", Geometry.ITEM, TurnTo::target), TurnTo::new));
}
