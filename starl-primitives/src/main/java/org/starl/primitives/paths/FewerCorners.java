package org.starl.primitives.paths;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.simplify.DouglasPeuckerSimplifier;
import org.starl.geometry.Point;

/**
 * Plans with more clearance than asked for, and spends it on fewer corners: another planner draws a
 * way around a wall's corner with many short chords, and a robot stops at each; a path with few
 * parts also fits one tube. Where an end has no clearance to spare, the path is the other
 * planner's. Immutable.
 *
 * <p>Leaves out points within the spare clearance of the line between those that stay (Douglas,
 * Peucker, "Algorithms for the reduction of the number of points required to represent a digitized
 * line", Cartographica 10(2), 1973), so the new path keeps the clearance that was asked for.
 */
public final class FewerCorners implements PathPlanner {

  /** More clearance than asked for, in mm. */
  public static final double SPARE_MM = 20;

  private static final double ROUNDING_MM = 1;

  private final PathPlanner planner;

  public FewerCorners(PathPlanner planner) {
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
    Coordinate[] points =
        path.points().stream()
            .map(point -> new Coordinate(point.xMm(), point.yMm()))
            .toArray(Coordinate[]::new);
    LineString line = new GeometryFactory().createLineString(points);
    Coordinate[] kept =
        DouglasPeuckerSimplifier.simplify(line, SPARE_MM - ROUNDING_MM).getCoordinates();
    return new Path(
        Arrays.stream(kept).map(at -> new Point(at.x, at.y)).collect(Collectors.toList()));
  }
}
