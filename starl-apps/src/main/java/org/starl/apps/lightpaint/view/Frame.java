package org.starl.apps.lightpaint.view;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.spec.Pass;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** The part of the floor that holds a drawing and all that was painted, with a margin; mm. */
record Frame(double xMinMm, double yMinMm, double widthMm, double heightMm) {

  private static final double MARGIN_MM = 100;

  static Frame of(List<Stroke> strokes, List<Pass> passes) {
    List<Point> points = new ArrayList<>();
    strokes.forEach(stroke -> points.addAll(stroke.path().points()));
    passes.forEach(pass -> points.addAll(pass.points()));
    Rectangle box = Rectangle.around(points).widened(MARGIN_MM);
    return new Frame(
        Math.floor(box.xMinMm()),
        Math.floor(box.yMinMm()),
        Math.ceil(box.xMaxMm() - box.xMinMm()),
        Math.ceil(box.yMaxMm() - box.yMinMm()));
  }

  /** From the left. */
  double x(Point point) {
    return point.xMm() - xMinMm;
  }

  /** From the top. */
  double y(Point point) {
    return yMinMm + heightMm - point.yMm();
  }
}
