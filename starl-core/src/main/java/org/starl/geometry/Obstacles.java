package org.starl.geometry;

import java.util.ArrayList;
import java.util.List;

/** All obstacles of a floor, or those that a robot knows. Immutable. */
public record Obstacles(List<Obstacle> all) {

  public static final Obstacles NONE = new Obstacles(List.of());

  public Obstacles {
    all = List.copyOf(all);
  }

  public static Obstacles of(Obstacle... all) {
    return new Obstacles(List.of(all));
  }

  /** Those that are not hidden: what every robot's map shows at the start. */
  public Obstacles known() {
    List<Obstacle> known = new ArrayList<>();
    for (Obstacle obstacle : all) {
      if (!obstacle.hidden()) {
        known.add(obstacle);
      }
    }
    return new Obstacles(known);
  }

  /** Those that still stand. */
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

  /** Distance from the nearest of them; infinite if there is none. */
  public double distanceMm(Point point) {
    double best = Double.POSITIVE_INFINITY;
    for (Obstacle obstacle : all) {
      best = Math.min(best, obstacle.distanceMm(point));
    }
    return best;
  }
}
