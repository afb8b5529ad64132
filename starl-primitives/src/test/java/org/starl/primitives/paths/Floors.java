package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

/** Random floors, with geometry that is independent of the planners. */
final class Floors {

  static final Rectangle BOUNDS = new Rectangle(0, 0, 4000, 3000);

  private Floors() {}

  /** A floor with walls, triangles and quadrangles, and two places on it. */
  static PlanTask random(Rng rng, int obstacles, double bodyMm, double clearanceMm) {
    List<Obstacle> all = new ArrayList<>();
    for (int i = 0; i < obstacles; i++) {
      all.add(obstacle(rng));
    }
    Obstacles floor = new Obstacles(all);
    Point start = freePlace(rng, floor, bodyMm + clearanceMm);
    Point goal = freePlace(rng, floor, bodyMm + clearanceMm);
    return new PlanTask(start, goal, BOUNDS, floor, List.of(), bodyMm, clearanceMm);
  }

  /** A place that is usually free: a crowded floor may have no free place. */
  private static Point freePlace(Rng rng, Obstacles floor, double marginMm) {
    Point place = place(rng);
    for (int i = 0; i < 30 && !isFree(place, floor, marginMm); i++) {
      place = place(rng);
    }
    return place;
  }

  private static boolean isFree(Point place, Obstacles floor, double marginMm) {
    return floor.distanceMm(place) > marginMm && BOUNDS.depthMm(place) > marginMm;
  }

  static PlanTask task(Point start, Point goal, double marginMm, Obstacle... obstacles) {
    return new PlanTask(start, goal, BOUNDS, Obstacles.of(obstacles), List.of(), marginMm, 0);
  }

  private static Point place(Rng rng) {
    return new Point(rng.nextDouble() * 4000, rng.nextDouble() * 3000);
  }

  private static Obstacle obstacle(Rng rng) {
    Point center = place(rng);
    int corners = 2 + rng.nextInt(3);
    double turn = rng.nextDouble();
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < corners; i++) {
      double angle = 2 * StrictMath.PI * (i + turn) / corners;
      double radius = 100 + rng.nextDouble() * 700;
      points.add(
          center.plus(new Point(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle))));
    }
    return new Obstacle(points, corners > 2, false, Obstacle.FOREVER);
  }

  /** The distance from a leg to the nearest obstacle; 0 if they meet. */
  static double clearanceMm(Segment leg, PlanTask task) {
    double least = Double.POSITIVE_INFINITY;
    for (Obstacle obstacle : task.obstacles().all()) {
      least = Math.min(least, obstacle.distanceMm(leg.from()));
      for (Segment side : obstacle.sides()) {
        least = Math.min(least, side.distanceMm(leg));
      }
    }
    for (Capsule taken : task.taken()) {
      least = Math.min(least, taken.axis().distanceMm(leg) - taken.radiusMm());
    }
    return Math.min(least, Math.min(depthMm(leg.from(), task), depthMm(leg.to(), task)));
  }

  private static double depthMm(Point point, PlanTask task) {
    return task.bounds().contains(point) ? task.bounds().depthMm(point) : -1;
  }
}
