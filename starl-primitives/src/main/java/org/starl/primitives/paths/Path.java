package org.starl.primitives.paths;

import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * A path of straight legs, in mm.
 *
 * @param points at least two, the start first; in whole mm if a planner made the path
 */
public record Path(List<Point> points) {

  private static final int MOST_POINTS = 0xFFFF;

  /** Its shape. */
  public static final Shape<Path> SHAPE =
      Shapes.of(
          Path.class,
          part("points", Shapes.list(Geometry.POINT, MOST_POINTS), Path::points),
          Path::new);

  public Path {
    points = List.copyOf(points);
    if (points.size() < 2) {
      throw new IllegalArgumentException(
          "path of " + points.size() + " points: expected at least 2");
    }
    for (Point point : points) {
      if (!point.isFinite()) {
        throw new IllegalArgumentException("path with point " + point + ": expected numbers");
      }
    }
  }

  /** The number of legs. */
  public int legs() {
    return points.size() - 1;
  }

  /** Leg number {@code i}, from 0. */
  public Segment leg(int i) {
    return new Segment(points.get(i), points.get(i + 1));
  }

  public Point start() {
    return points.get(0);
  }

  public Point goal() {
    return points.get(points.size() - 1);
  }

  public double lengthMm() {
    double sum = 0;
    for (int i = 0; i < legs(); i++) {
      sum += points.get(i).distanceMm(points.get(i + 1));
    }
    return sum;
  }
}
