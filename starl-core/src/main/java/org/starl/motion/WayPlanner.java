package org.starl.motion;

import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;

/** Plans the way of a motion, beside the strand: the body stands meanwhile. */
@FunctionalInterface
public interface WayPlanner {

  /**
   * Begins to plan.
   *
   * @return null until the plan is made; then the corners of the way, the target last; only the
   *     target if nothing is in the way; empty if there is no way
   */
  Supplier<@Nullable List<Point>> plan(Location.Known from);
}
