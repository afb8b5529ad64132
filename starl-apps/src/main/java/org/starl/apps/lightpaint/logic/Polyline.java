package org.starl.apps.lightpaint.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Straight lines from each point to the next, measured along.
 *
 * @param points at least two, in mm, no two in a row equal
 */
public record Polyline(List<Point> points) {

  public Polyline {
    points = List.copyOf(points);
    if (points.size() < 2) {
      throw new IllegalArgumentException(
          "polyline of " + points.size() + " points: expected at least 2");
    }
    for (int i = 1; i < points.size(); i++) {
      if (points.get(i).equals(points.get(i - 1)) || !points.get(i).isFinite()) {
        throw new IllegalArgumentException(
            "polyline with " + points.get(i) + ": expected numbers, none twice in a row");
      }
    }
  }

  public int legs() {
    return points.size() - 1;
  }

  public Segment leg(int i) {
    return new Segment(points.get(i), points.get(i + 1));
  }

  public Point start() {
    return points.get(0);
  }

  public Point end() {
    return points.get(points.size() - 1);
  }

  public double lengthMm() {
    double sum = 0;
    for (int i = 0; i < legs(); i++) {
      sum += legMm(i);
    }
    return sum;
  }

  /** The place {@code alongMm} from the start; beyond an end, that end. */
  public Point at(double alongMm) {
    double rest = alongMm;
    for (int i = 0; i < legs(); i++) {
      double lengthMm = legMm(i);
      if (rest <= lengthMm) {
        Segment leg = leg(i);
        return leg.from().plus(leg.to().minus(leg.from()).times(Math.max(0, rest) / lengthMm));
      }
      rest -= lengthMm;
    }
    return end();
  }

  /** The part between two places, each measured from the start; {@code fromMm < toMm}. */
  public Polyline between(double fromMm, double toMm) {
    List<Point> part = new ArrayList<>();
    part.add(at(fromMm));
    double sum = 0;
    for (int i = 0; i < legs(); i++) {
      sum += legMm(i);
      if (sum > fromMm && sum < toMm) {
        part.add(points.get(i + 1));
      }
    }
    part.add(at(toMm));
    return new Polyline(withoutRepeats(part));
  }

  /**
   * The distance from the start, between {@code fromMm} and {@code toMm}, of the place nearest to
   * {@code point}; the first of several.
   */
  public double nearestMm(Point point, double fromMm, double toMm) {
    double best = Double.POSITIVE_INFINITY;
    double bestMm = fromMm;
    double sum = 0;
    for (int i = 0; i < legs(); i++) {
      double lengthMm = legMm(i);
      double lowMm = Math.max(fromMm, sum);
      double highMm = Math.min(toMm, sum + lengthMm);
      if (lowMm <= highMm) {
        Point direction = leg(i).to().minus(leg(i).from()).times(1 / lengthMm);
        double onLineMm = sum + point.minus(leg(i).from()).dot(direction);
        double alongMm = Math.max(lowMm, Math.min(highMm, onLineMm));
        Point place = leg(i).from().plus(direction.times(alongMm - sum));
        double distanceMm = place.distanceMm(point);
        if (distanceMm < best) {
          best = distanceMm;
          bestMm = alongMm;
        }
      }
      sum += lengthMm;
    }
    return bestMm;
  }

  public double distanceMm(Point point) {
    double leastMm = Double.POSITIVE_INFINITY;
    for (int i = 0; i < legs(); i++) {
      leastMm = Math.min(leastMm, leg(i).distanceMm(point));
    }
    return leastMm;
  }

  public double distanceMm(Polyline other) {
    double leastMm = Double.POSITIVE_INFINITY;
    for (int i = 0; i < legs(); i++) {
      for (int j = 0; j < other.legs(); j++) {
        leastMm = Math.min(leastMm, leg(i).distanceMm(other.leg(j)));
      }
    }
    return leastMm;
  }

  /** The same line from its end to its start. */
  public Polyline reversed() {
    List<Point> reversed = new ArrayList<>(points);
    Collections.reverse(reversed);
    return new Polyline(reversed);
  }

  private double legMm(int i) {
    return points.get(i).distanceMm(points.get(i + 1));
  }

  /** The point on whole millimetres that is nearest. */
  public static Point rounded(Point point) {
    return new Point(StrictMath.rint(point.xMm()), StrictMath.rint(point.yMm()));
  }

  /** The points, none twice in a row. */
  public static List<Point> withoutRepeats(List<Point> points) {
    List<Point> kept = new ArrayList<>();
    for (Point point : points) {
      if (kept.isEmpty() || !kept.get(kept.size() - 1).equals(point)) {
        kept.add(point);
      }
    }
    return kept;
  }

  /**
   * The points without those that the line does not need to stay within {@code toleranceMm} of all of
   * them, none twice in a row (Douglas, Peucker, "Algorithms for the reduction of the number of points
   * required to represent a digitized line or its caricature", Cartographica 10(2), 1973).
   */
  public static List<Point> simplified(List<Point> points, double toleranceMm) {
    BitSet needed = new BitSet(points.size());
    Deque<int[]> ranges = new ArrayDeque<>();
    if (!points.isEmpty()) {
      needed.set(0);
      needed.set(points.size() - 1);
      ranges.push(new int[] {0, points.size() - 1});
    }
    while (!ranges.isEmpty()) {
      int[] range = ranges.pop();
      Segment chord = new Segment(points.get(range[0]), points.get(range[1]));
      int farthest = -1;
      double farthestMm = toleranceMm;
      for (int i = range[0] + 1; i < range[1]; i++) {
        double distanceMm = chord.distanceMm(points.get(i));
        if (distanceMm > farthestMm) {
          farthest = i;
          farthestMm = distanceMm;
        }
      }
      if (farthest >= 0) {
        needed.set(farthest);
        ranges.push(new int[] {range[0], farthest});
        ranges.push(new int[] {farthest, range[1]});
      }
    }
    return withoutRepeats(needed.stream().mapToObj(points::get).collect(Collectors.toList()));
  }
}
