package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/** Joins lines of one ink that meet end to end. */
final class Chains {

  /** What lies nearer to a line than this is on it. */
  private static final double STRAIGHT_MM = 1;

  private Chains() {}

  static List<Line> of(List<Line> lines, double sameMm) {
    List<Line> chains = new ArrayList<>();
    for (Line line : lines) {
      Line grown = line;
      for (int i = chains.size() - 1; i >= 0; i--) {
        Line joined = join(chains.get(i), grown, sameMm);
        if (joined != null) {
          chains.remove(i);
          grown = joined;
        }
      }
      chains.add(grown);
    }
    return chains;
  }

  private static @Nullable Line join(Line a, Line b, double sameMm) {
    if (!a.ink().equals(b.ink()) || isClosed(a, sameMm) || isClosed(b, sameMm)) {
      return null;
    }
    Polyline p = a.path();
    Polyline q = b.path();
    if (near(p.end(), q.start(), sameMm)) {
      return joined(p, q, a.ink());
    }
    if (near(p.end(), q.end(), sameMm)) {
      return joined(p, q.reversed(), a.ink());
    }
    if (near(p.start(), q.end(), sameMm)) {
      return joined(q, p, a.ink());
    }
    return near(p.start(), q.start(), sameMm) ? joined(p.reversed(), q, a.ink()) : null;
  }

  private static boolean isClosed(Line line, double sameMm) {
    return near(line.path().start(), line.path().end(), sameMm);
  }

  private static boolean near(Point a, Point b, double sameMm) {
    return a.distanceMm(b) <= sameMm;
  }

  private static Line joined(Polyline first, Polyline second, Ink ink) {
    List<Point> points = new ArrayList<>(first.points());
    List<Point> more = second.points();
    for (Point point : more.subList(isCorner(first, second) ? 0 : 1, more.size())) {
      if (!points.get(points.size() - 1).equals(point)) {
        points.add(point);
      }
    }
    return new Line(new Polyline(points), ink);
  }

  /** Whether the drawing would look another if the place were left out where the second begins. */
  private static boolean isCorner(Polyline first, Polyline second) {
    Point start = second.start();
    Point next = second.points().get(1);
    boolean isOnTheWay = new Segment(first.end(), next).distanceMm(start) <= STRAIGHT_MM;
    boolean isBehind =
        first.leg(first.legs() - 1).distanceMm(start) <= STRAIGHT_MM
            && second.leg(0).distanceMm(first.end()) <= STRAIGHT_MM;
    return !isOnTheWay && !isBehind;
  }
}
