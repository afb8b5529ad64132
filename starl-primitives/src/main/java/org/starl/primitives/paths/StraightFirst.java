package org.starl.primitives.paths;

import java.util.List;
import org.starl.geometry.Segment;

/**
 * Uses the straight line if it is free, without the costly free space; otherwise asks another
 * planner. For tasks that mostly have straight paths. Immutable.
 */
public final class StraightFirst implements PathPlanner {

  /** Extra clearance for the rounding of the ends to whole mm. */
  static final double ROUNDING_MM = 2;

  private final PathPlanner planner;

  public StraightFirst(PathPlanner planner) {
    this.planner = planner;
  }

  @Override
  public Plan plan(PlanTask task) {
    Segment way = new Segment(Tube.rounded(task.start()), Tube.rounded(task.goal()));
    boolean isFree = task.keepOut().isEmpty() && !way.from().equals(way.to()) && isFree(way, task);
    return isFree ? new Plan.Found(new Path(List.of(way.from(), way.to()))) : planner.plan(task);
  }

  private static boolean isFree(Segment way, PlanTask task) {
    double marginMm = task.marginMm() + ROUNDING_MM;
    return task.bounds().depthMm(way.from()) >= marginMm
        && task.bounds().depthMm(way.to()) >= marginMm
        && task.taken().stream()
            .allMatch(other -> way.distanceMm(other.axis()) >= other.radiusMm() + marginMm)
        && !task.obstacles().isWithin(way, marginMm);
  }
}
