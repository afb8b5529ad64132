package org.starl.primitives.paths;

import java.util.Arrays;
import java.util.stream.Collectors;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.simplify.DouglasPeuckerSimplifier;
import org.starl.geometry.Point;

/**
 * Asks another planner for a path with extra clearance, and uses this clearance to remove corners.
 * The other planner's path around a corner has many short chords, and a robot stops at each. A path
 * with few parts also fits one tube. Where an end has no extra clearance, the path stays as the
 * other planner made it. Immutable.
 *
 * <p>Removes points within the extra clearance of the line between the remaining ones (Douglas,
 * Peucker, "Algorithms for the reduction of the number of points required to represent a digitized
 * line", Cartographica 10(2), 1973), so the new path keeps the requested clearance.
 */
public final class FewerCorners implements PathPlanner {

  /** The extra clearance, in mm. */
  public static final double SPARE_MM = 20;

  private static final double ROUNDING_MM = 1;

  private final PathPlanner planner;

  public FewerCorners(PathPlanner planner) {
    this.planner = planner;
  }

  @Override
  public Plan plan(PlanTask task) {
    Plan plan = planner.plan(task.withClearanceMm(task.clearanceMm() + SPARE_MM));
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
