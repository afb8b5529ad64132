package org.starl.sim.record;

import java.awt.geom.AffineTransform;
import org.starl.RobotId;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;

/** The part of the world that a picture shows: everything that stands or ever moved there. */
final class Extent {

  private double xMinMm = Double.POSITIVE_INFINITY;
  private double yMinMm = Double.POSITIVE_INFINITY;
  private double xMaxMm = Double.NEGATIVE_INFINITY;
  private double yMaxMm = Double.NEGATIVE_INFINITY;

  private Extent() {}

  static Extent of(Scene scene, Layer layer) {
    Extent extent = new Extent();
    layer.corners().forEach(extent::add);
    for (Obstacle obstacle : scene.obstacles().all()) {
      obstacle.points().forEach(extent::add);
    }
    for (RobotId robot : scene.robots()) {
      scene.trail(robot).forEach(extent::add);
    }
    if (extent.xMinMm > extent.xMaxMm) {
      extent.add(new Point(0, 0));
    }
    return extent;
  }

  private void add(Point point) {
    xMinMm = Math.min(xMinMm, point.xMm());
    yMinMm = Math.min(yMinMm, point.yMm());
    xMaxMm = Math.max(xMaxMm, point.xMm());
    yMaxMm = Math.max(yMaxMm, point.yMm());
  }

  /** Fits it into a square of pixels, upright: the world's y points up, a picture's down. */
  AffineTransform toPixels(int sizePx, int marginPx, double worldMarginMm) {
    double widthMm = xMaxMm - xMinMm + 2 * worldMarginMm;
    double heightMm = yMaxMm - yMinMm + 2 * worldMarginMm;
    double scale = (sizePx - 2.0 * marginPx) / Math.max(widthMm, heightMm);
    AffineTransform transform = new AffineTransform();
    transform.translate(sizePx / 2.0, sizePx / 2.0);
    transform.scale(scale, -scale);
    transform.translate(-(xMinMm + xMaxMm) / 2, -(yMinMm + yMaxMm) / 2);
    return transform;
  }
}
