package org.starl.geometry;

import java.util.List;

/**
 * A simple polygon, convex or not, with its border.
 *
 * @param vertices at least three, in either orientation, the first one not repeated; sides meet
 *     only at common vertices of neighbours
 */
public record Polygon(List<Point> vertices) implements Region {

  public Polygon {
    vertices = List.copyOf(vertices);
    check(vertices);
  }

  public static Polygon of(Point... vertices) {
    return new Polygon(List.of(vertices));
  }

  /** The side from vertex {@code i} to the next one. */
  public Segment side(int i) {
    return side(vertices, i);
  }

  @Override
  public boolean contains(Point point) {
    return Outlines.contains(vertices, point);
  }

  @Override
  public double distanceMm(Point point) {
    return contains(point) ? 0 : Outlines.borderDistanceMm(vertices, true, point);
  }

  @Override
  public double depthMm(Point point) {
    return contains(point) ? Outlines.borderDistanceMm(vertices, true, point) : 0;
  }

  private static Segment side(List<Point> vertices, int i) {
    return new Segment(vertices.get(i), vertices.get((i + 1) % vertices.size()));
  }

  private static void check(List<Point> vertices) {
    int n = vertices.size();
    if (n < 3) {
      throw new IllegalArgumentException("polygon of " + n + " vertices: expected at least 3");
    }
    for (Point vertex : vertices) {
      if (!vertex.isFinite()) {
        throw new IllegalArgumentException("polygon with vertex " + vertex + ": expected numbers");
      }
    }
    for (int i = 0; i < n; i++) {
      for (int j = i + 1; j < n; j++) {
        boolean neighbours = j == i + 1 || (i == 0 && j == n - 1);
        boolean meet =
            neighbours
                ? foldsBack(side(vertices, i), side(vertices, j))
                : side(vertices, i).crosses(side(vertices, j));
        if (meet) {
          throw new IllegalArgumentException(
              "polygon whose sides " + i + " and " + j + " meet: expected a simple one");
        }
      }
    }
  }

  /** Whether neighbouring sides share more than their common vertex. */
  private static boolean foldsBack(Segment a, Segment b) {
    Point u = a.to().minus(a.from());
    Point v = b.to().minus(b.from());
    return u.cross(v) == 0 && (u.dot(v) <= 0);
  }

  /** For people: a long one is shortened. {@link RegionText#format} has all of it. */
  @Override
  public String toString() {
    return RegionText.brief(this);
  }
}
