package org.starl.geometry;

import static org.starl.time.Time.NS_PER_MS;

import java.util.ArrayList;
import java.util.List;

/**
 * An obstacle on the floor.
 *
 * @param points at least two: the line of a wall, or the corners of a solid body
 * @param closed whether the last point is joined to the first and the inside is solid
 * @param hidden present in the world, but on no robot's map until the robot bumps into it
 * @param lifetimeMs how long it exists from the start of the run, or {@link #FOREVER}
 */
public record Obstacle(List<Point> points, boolean closed, boolean hidden, long lifetimeMs) {

  public static final long FOREVER = -1;

  public Obstacle {
    points = List.copyOf(points);
    if (points.size() < (closed ? 3 : 2)) {
      throw new IllegalArgumentException(
          "obstacle of " + points.size() + " points: expected at least " + (closed ? 3 : 2));
    }
    for (Point point : points) {
      if (!point.isFinite()) {
        throw new IllegalArgumentException("obstacle with point " + point + ": expected numbers");
      }
    }
    if (lifetimeMs < 0 && lifetimeMs != FOREVER) {
      throw new IllegalArgumentException(
          "obstacle's lifetime " + lifetimeMs + " ms: expected at least 0, or -1 for ever");
    }
  }

  /** A known wall that always exists. */
  public static Obstacle wall(Point... points) {
    return new Obstacle(List.of(points), false, false, FOREVER);
  }

  /** A known solid body that always exists. */
  public static Obstacle body(Point... corners) {
    return new Obstacle(List.of(corners), true, false, FOREVER);
  }

  /** Whether it still exists. */
  public boolean standsAt(long timeNs) {
    return lifetimeMs == FOREVER || timeNs < lifetimeMs * NS_PER_MS;
  }

  /** Distance to the nearest point of the obstacle; 0 inside a solid one. */
  public double distanceMm(Point point) {
    return closed && Outlines.contains(points, point)
        ? 0
        : Outlines.borderDistanceMm(points, closed, point);
  }

  /** Its line segments, in order. */
  public List<Segment> sides() {
    List<Segment> sides = new ArrayList<>(points.size());
    for (int i = 1; i < points.size(); i++) {
      sides.add(new Segment(points.get(i - 1), points.get(i)));
    }
    if (closed) {
      sides.add(new Segment(points.get(points.size() - 1), points.get(0)));
    }
    return sides;
  }
}
