package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.List;
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
        throw new IllegalArgumentException("polyline with " + points.get(i) + " twice in a row");
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

  /** The place {@code alongMm} from the start; an end for less than 0 or more than the length. */
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

  /** What lies between two places, each measured from the start; {@code fromMm} is before {@code toMm}. */
  public Polyline between(double fromMm, double toMm) {
    List<Point> part = new ArrayList<>();
    part.add(at(fromMm));
    double sum = 0;
    for (int i = 0; i < legs(); i++) {
      sum += legMm(i);
      if (sum > fromMm && sum < toMm) {
        append(part, points.get(i + 1));
      }
    }
    append(part, at(toMm));
    return new Polyline(part);
  }

  private static void append(List<Point> part, Point point) {
    if (!part.get(part.size() - 1).equals(point)) {
      part.add(point);
    }
  }

  /**
   * How far along the place is that is nearest to {@code point}, of those from {@code fromMm} to {@code
   * toMm}; the first of several.
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
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < legs(); i++) {
      least = Math.min(least, leg(i).distanceMm(point));
    }
    return least;
  }

  public double distanceMm(Polyline other) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < legs(); i++) {
      for (int j = 0; j < other.legs(); j++) {
        least = Math.min(least, leg(i).distanceMm(other.leg(j)));
      }
    }
    return least;
  }

  /** The same from its end to its start. */
  public Polyline reversed() {
    List<Point> reversed = new ArrayList<>();
    for (int i = points.size() - 1; i >= 0; i--) {
      reversed.add(points.get(i));
    }
    return new Polyline(reversed);
  }

  private double legMm(int i) {
    return points.get(i).distanceMm(points.get(i + 1));
  }
}
