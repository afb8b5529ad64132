package org.starl.apps.lightpaint;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * The floor around a drawing: as wide as the drawing, and beyond it a margin in which every painter
 * has a place of its own, as far from each other as can be.
 *
 * @param floor bodies stay inside
 * @param places one for each painter; nobody at work is in the way of a painter there
 */
record Room(Rectangle floor, List<Point> places) {

  private static final double SPARE_MM = 30;

  Room {
    places = List.copyOf(places);
  }

  /**
   * @param also places that must be on the floor as well: where painters start
   * @param radiusMm half the width of a tube
   */
  static Room around(List<Stroke> strokes, List<Point> also, int painters, double radiusMm) {
    List<Point> points = new ArrayList<>(also);
    strokes.forEach(stroke -> points.addAll(stroke.path().points()));
    Rectangle inside = Rectangle.around(points);
    // A painter may pass at the very border of the drawing while others are in their places.
    double marginMm = 2 * radiusMm + SPARE_MM;
    double apartMm = 2 * radiusMm + SPARE_MM;
    while (perimeterMm(inside.widened(marginMm)) < painters * apartMm) {
      marginMm += apartMm;
    }
    Rectangle ring = inside.widened(marginMm);
    List<Point> places = new ArrayList<>();
    double stepMm = perimeterMm(ring) / painters;
    for (int i = 0; i < painters; i++) {
      places.add(along(ring, stepMm * (i + 0.5)));
    }
    return new Room(ring.widened(radiusMm + SPARE_MM), places);
  }

  private static double perimeterMm(Rectangle ring) {
    return 2 * (ring.xMaxMm() - ring.xMinMm() + ring.yMaxMm() - ring.yMinMm());
  }

  /** The place so far along the ring, from its lower left corner counter-clockwise. */
  private static Point along(Rectangle ring, double mm) {
    double width = ring.xMaxMm() - ring.xMinMm();
    double height = ring.yMaxMm() - ring.yMinMm();
    if (mm < width) {
      return whole(ring.xMinMm() + mm, ring.yMinMm());
    }
    if (mm < width + height) {
      return whole(ring.xMaxMm(), ring.yMinMm() + mm - width);
    }
    if (mm < 2 * width + height) {
      return whole(ring.xMaxMm() - (mm - width - height), ring.yMaxMm());
    }
    return whole(ring.xMinMm(), ring.yMaxMm() - (mm - 2 * width - height));
  }

  private static Point whole(double xMm, double yMm) {
    return new Point(StrictMath.rint(xMm), StrictMath.rint(yMm));
  }
}
