package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.random.Rng;

/** Shortens a path within the free space. */
record Smoother(FreeSpace space, Rng rng) {

  /** Removes needless points, then cuts corners at random points, then removes points again. */
  List<Point> smooth(List<Point> points, int shortcuts) {
    List<Point> path = withoutDetours(points);
    for (int i = 0; i < shortcuts && path.size() > 2; i++) {
      path = cutCorner(path);
    }
    return withoutDetours(path);
  }

  /** Connects each point directly to the last visible one. */
  private List<Point> withoutDetours(List<Point> points) {
    List<Point> kept = new ArrayList<>();
    int at = 0;
    kept.add(points.get(0));
    while (at < points.size() - 1) {
      int to = points.size() - 1;
      while (to > at + 1 && !sees(points.get(at), points.get(to))) {
        to--;
      }
      kept.add(points.get(to));
      at = to;
    }
    return kept;
  }

  /** Connects a random point of one leg with a random point of the next, if this line is free. */
  private List<Point> cutCorner(List<Point> path) {
    int corner = 1 + rng.nextInt(path.size() - 2);
    Point from = between(path.get(corner), path.get(corner - 1), rng.nextDouble());
    Point to = between(path.get(corner), path.get(corner + 1), rng.nextDouble());
    Point before = path.get(corner - 1);
    Point after = path.get(corner + 1);
    // Points on a leg are rounded, so each of the three new legs must be checked.
    if (!isFree(from)
        || !isFree(to)
        || !sees(before, from)
        || !sees(from, to)
        || !sees(to, after)) {
      return path;
    }
    double newMm = before.distanceMm(from) + from.distanceMm(to) + to.distanceMm(after);
    double oldMm = before.distanceMm(path.get(corner)) + path.get(corner).distanceMm(after);
    if (newMm >= oldMm) {
      return path;
    }
    List<Point> shorter = new ArrayList<>(path.subList(0, corner));
    addIfNew(shorter, from);
    addIfNew(shorter, to);
    if (shorter.get(shorter.size() - 1).equals(after)) {
      shorter.remove(shorter.size() - 1);
    }
    shorter.addAll(path.subList(corner + 1, path.size()));
    return shorter;
  }

  private static void addIfNew(List<Point> path, Point point) {
    if (!path.get(path.size() - 1).equals(point)) {
      path.add(point);
    }
  }

  private static Point between(Point from, Point to, double part) {
    Point exact = from.plus(to.minus(from).times(part));
    return new Point(FreeSpace.x(exact), FreeSpace.y(exact));
  }

  private boolean isFree(Point point) {
    return space.isFree(FreeSpace.x(point), FreeSpace.y(point));
  }

  private boolean sees(Point from, Point to) {
    return space.sees(FreeSpace.x(from), FreeSpace.y(from), FreeSpace.x(to), FreeSpace.y(to));
  }
}
