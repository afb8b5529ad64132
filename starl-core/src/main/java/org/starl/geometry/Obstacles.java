package org.starl.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** All obstacles of a floor, or all that a robot knows. Immutable. */
public record Obstacles(List<Obstacle> all) {

  public static final Obstacles NONE = new Obstacles(List.of());

  public Obstacles {
    all = List.copyOf(all);
  }

  public static Obstacles of(Obstacle... all) {
    return new Obstacles(List.of(all));
  }

  /** The obstacles that are not hidden: every robot's map at the start. */
  public Obstacles known() {
    return new Obstacles(
        all.stream().filter(obstacle -> !obstacle.hidden()).collect(Collectors.toList()));
  }

  /** The obstacles that still exist. */
  public Obstacles standingAt(long timeNs) {
    List<Obstacle> standing = new ArrayList<>();
    for (Obstacle obstacle : all) {
      if (obstacle.standsAt(timeNs)) {
        standing.add(obstacle);
      }
    }
    return standing.size() == all.size() ? this : new Obstacles(standing);
  }

  public Obstacles plus(Obstacle more) {
    List<Obstacle> joined = new ArrayList<>(all);
    joined.add(more);
    return new Obstacles(joined);
  }

  public boolean isEmpty() {
    return all.isEmpty();
  }

  /** Whether a side of an obstacle cuts or touches the straight line between two points. */
  public boolean hide(Point one, Point other) {
    Segment line = new Segment(one, other);
    return all.stream().anyMatch(body -> body.sides().stream().anyMatch(line::crosses));
  }

  /** Whether an obstacle is nearer to a straight line than this. */
  public boolean isWithin(Segment line, double mm) {
    return all.stream()
        // In a solid obstacle, the line might be far from all sides.
        .anyMatch(obstacle ->
            obstacle.distanceMm(line.from()) < mm
                || obstacle.sides().stream().anyMatch(side -> line.distanceMm(side) < mm));
  }

  /** Distance to the nearest obstacle; infinite if there is none. */
  public double distanceMm(Point point) {
    double best = Double.POSITIVE_INFINITY;
    for (Obstacle obstacle : all) {
      best = Math.min(best, obstacle.distanceMm(point));
    }
    return best;
  }
}
