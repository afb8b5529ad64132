package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.primitives.paths.Path;
import org.starl.primitives.paths.PathPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;

/**
 * Plans with some clearance to spare, and spends it on fewer corners: a planner draws the round corners
 * of walls with many short chords, and a robot stops at each. A path with few parts fits one tube, too.
 * Where an end has no clearance to spare, the path is as the planner makes it. Immutable.
 *
 * <p>Points are left out that are within the spare clearance of the line between those that stay
 * (Douglas, Peucker, "Algorithms for the reduction of the number of points required to represent a
 * digitized line", Cartographica 10(2), 1973), so the new line keeps the clearance that was asked for.
 */
final class FewerCorners implements PathPlanner {

  /** More clearance than is asked for. */
  static final double SPARE_MM = 20;

  private final PathPlanner planner;

  FewerCorners(PathPlanner planner) {
    this.planner = planner;
  }

  @Override
  public Plan plan(PlanTask task) {
    PlanTask wider =
        new PlanTask(
            task.start(),
            task.goal(),
            task.bounds(),
            task.obstacles(),
            task.taken(),
            task.keepOut(),
            task.bodyRadiusMm(),
            task.clearanceMm() + SPARE_MM);
    Plan plan = planner.plan(wider);
    return switch (plan) {
      case Plan.Found found -> new Plan.Found(fewer(found.path()));
      case Plan.Blocked blocked -> planner.plan(task);
      case Plan.NoPath none -> plan;
      case Plan.GaveUp gaveUp -> plan;
    };
  }

  private static Path fewer(Path path) {
    List<Point> kept = new ArrayList<>();
    kept.add(path.start());
    keep(path.points(), 0, path.legs(), kept);
    return new Path(kept);
  }

  /** Adds what must stay of the points behind {@code from}, up to {@code to}. */
  private static void keep(List<Point> points, int from, int to, List<Point> kept) {
    Segment line = new Segment(points.get(from), points.get(to));
    int farthest = from;
    double mostMm = SPARE_MM - 1; // points are rounded to whole mm
    for (int i = from + 1; i < to; i++) {
      double mm = line.distanceMm(points.get(i));
      if (mm > mostMm) {
        mostMm = mm;
        farthest = i;
      }
    }
    if (farthest == from) {
      kept.add(points.get(to));
    } else {
      keep(points, from, farthest, kept);
      keep(points, farthest, to, kept);
    }
  }
}
