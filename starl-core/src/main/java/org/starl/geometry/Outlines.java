package org.starl.geometry;

import java.util.List;

/** Functions on polylines and outlines, given as lists of points. */
final class Outlines {

  private Outlines() {}

  /** Whether {@code point} is inside a closed outline (even-odd rule) or on its border. */
  static boolean contains(List<Point> outline, Point point) {
    double px = point.xMm();
    double py = point.yMm();
    boolean inside = false;
    Point a = outline.get(outline.size() - 1);
    for (int i = 0; i < outline.size(); i++) {
      Point b = outline.get(i);
      if (new Segment(a, b).contains(point)) {
        return true;
      }
      boolean straddles = (a.yMm() > py) != (b.yMm() > py);
      if (straddles) {
        double side = (b.xMm() - a.xMm()) * (py - a.yMm()) - (b.yMm() - a.yMm()) * (px - a.xMm());
        if ((side > 0) == (b.yMm() > a.yMm())) {
          inside = !inside;
        }
      }
      a = b;
    }
    return inside;
  }

  /** Distance to the nearest segment of the outline. */
  static double borderDistanceMm(List<Point> outline, boolean closed, Point point) {
    double best = Double.POSITIVE_INFINITY;
    int last = outline.size() - 1;
    Point a = closed ? outline.get(last) : outline.get(0);
    for (int i = closed || last == 0 ? 0 : 1; i <= last; i++) {
      Point b = outline.get(i);
      best =
          Math.min(
              best,
              Segment.distanceMm(a.xMm(), a.yMm(), b.xMm(), b.yMm(), point.xMm(), point.yMm()));
      a = b;
    }
    return best;
  }
}
