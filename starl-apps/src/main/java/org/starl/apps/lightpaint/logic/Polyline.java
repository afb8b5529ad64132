package org.starl.apps.lightpaint.logic;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Straight legs from each point to the next. A place on it is given by its distance along the line
 * from the start.
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

  public List<Segment> legs() {
    List<Segment> legs = new ArrayList<>(points.size() - 1);
    for (int i = 1; i < points.size(); i++) {
      legs.add(new Segment(points.get(i - 1), points.get(i)));
    }
    return legs;
  }

  public Point start() {
    return points.get(0);
  }

  public Point end() {
    return points.get(points.size() - 1);
  }

  public double lengthMm() {
    return lengthMm(points);
  }

  /** The length of the line through {@code points}; 0 if there is only one. */
  public static double lengthMm(List<Point> points) {
    double sum = 0;
    for (int i = 1; i < points.size(); i++) {
      sum += points.get(i - 1).distanceMm(points.get(i));
    }
    return sum;
  }

  /** The place {@code alongMm} from the start; beyond an end, that end. */
  public Point at(double alongMm) {
    double rest = Math.max(0, alongMm);
    for (Segment leg : legs()) {
      double legMm = leg.from().distanceMm(leg.to());
      if (rest <= legMm) {
        return leg.from().plus(leg.to().minus(leg.from()).times(rest / legMm));
      }
      rest -= legMm;
    }
    return end();
  }

  /** The part between two places; {@code fromMm < toMm}. */
  public Polyline between(double fromMm, double toMm) {
    List<Point> part = new ArrayList<>();
    part.add(at(fromMm));
    double sum = 0;
    for (Segment leg : legs()) {
      sum += leg.from().distanceMm(leg.to());
      if (sum > fromMm && sum < toMm) {
        part.add(leg.to());
      }
    }
    part.add(at(toMm));
    return new Polyline(simplified(part, 0));
  }

  /**
   * The place between {@code fromMm} and {@code toMm} nearest to {@code point}; the first of
   * several.
   */
  public double nearestMm(Point point, double fromMm, double toMm) {
    double best = Double.POSITIVE_INFINITY;
    double bestMm = fromMm;
    double sum = 0;
    for (Segment leg : legs()) {
      double lowMm = Math.max(fromMm, sum);
      double highMm = Math.min(toMm, sum + leg.from().distanceMm(leg.to()));
      if (lowMm <= highMm) {
        double onLegMm = sum + leg.from().distanceMm(leg.nearest(point));
        double alongMm = Math.max(lowMm, Math.min(highMm, onLegMm));
        double distanceMm = at(alongMm).distanceMm(point);
        if (distanceMm < best) {
          best = distanceMm;
          bestMm = alongMm;
        }
      }
      sum += leg.from().distanceMm(leg.to());
    }
    return bestMm;
  }

  /**
   * The places on this line, in order, whose distance to {@code point} is a minimum among the places
   * beside them, and at most {@code withinMm}.
   */
  public List<Double> feetMm(Point point, double withinMm) {
    List<Double> feet = new ArrayList<>();
    List<Segment> legs = legs();
    double sum = 0;
    for (int i = 0; i < legs.size(); i++) {
      Segment leg = legs.get(i);
      Point foot = leg.nearest(point);
      // The foot at a corner is a minimum of both legs, or of none.
      boolean isFoot =
          (i == 0 || !foot.equals(leg.from()))
              && (i == legs.size() - 1
                  || !foot.equals(leg.to())
                  || legs.get(i + 1).nearest(point).equals(leg.to()));
      if (isFoot && foot.distanceMm(point) <= withinMm) {
        feet.add(sum + leg.from().distanceMm(foot));
      }
      sum += leg.from().distanceMm(leg.to());
    }
    return feet;
  }

  public double distanceMm(Point point) {
    return distanceMm(new Segment(point, point));
  }

  public double distanceMm(Polyline other) {
    return other.legs().stream().mapToDouble(this::distanceMm).min().orElseThrow();
  }

  public double distanceMm(Segment other) {
    return legs().stream().mapToDouble(other::distanceMm).min().orElseThrow();
  }

  /** The same line from its end to its start. */
  public Polyline reversed() {
    List<Point> reversed = new ArrayList<>(points);
    Collections.reverse(reversed);
    return new Polyline(reversed);
  }

  /** The point on whole millimetres that is nearest. */
  public static Point rounded(Point point) {
    return new Point(StrictMath.rint(point.xMm()), StrictMath.rint(point.yMm()));
  }

  /**
   * The points without those that the line does not need to stay within {@code toleranceMm} of all
   * of them, none twice in a row (Douglas, Peucker, "Algorithms for the reduction of the number of
   * points required to represent a digitized line or its caricature", Cartographica 10(2), 1973).
   *
   * @param points at least one
   */
  public static List<Point> simplified(List<Point> points, double toleranceMm) {
    List<Point> kept = new ArrayList<>(points.subList(0, 1));
    Deque<Integer> ends = new ArrayDeque<>(List.of(points.size() - 1));
    int from = 0;
    while (!ends.isEmpty()) {
      int to = ends.peek();
      Segment chord = new Segment(points.get(from), points.get(to));
      int farthest = to;
      double farthestMm = toleranceMm;
      for (int i = from + 1; i < to; i++) {
        double distanceMm = chord.distanceMm(points.get(i));
        if (distanceMm > farthestMm) {
          farthest = i;
          farthestMm = distanceMm;
        }
      }
      if (farthest < to) {
        ends.push(farthest);
      } else {
        if (!chord.to().equals(kept.get(kept.size() - 1))) {
          kept.add(chord.to());
        }
        from = ends.pop();
      }
    }
    return kept;
  }
}
