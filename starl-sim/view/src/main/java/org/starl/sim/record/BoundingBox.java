package org.starl.sim.record;

import org.starl.geometry.Point;

/** Bounding box of points of the world; grows when points are added. */
public final class BoundingBox {

  private double xMinMm = Double.POSITIVE_INFINITY;
  private double yMinMm = Double.POSITIVE_INFINITY;
  private double xMaxMm = Double.NEGATIVE_INFINITY;
  private double yMaxMm = Double.NEGATIVE_INFINITY;

  /**
   * The part of the world that a picture shows: obstacles, paths of robots, and the layer's
   * corners.
   */
  public static BoundingBox of(Scene scene, Layer layer) {
    BoundingBox extent = scene.extent().copy();
    layer.corners().forEach(extent::add);
    return extent;
  }

  BoundingBox copy() {
    BoundingBox copy = new BoundingBox();
    copy.xMinMm = xMinMm;
    copy.yMinMm = yMinMm;
    copy.xMaxMm = xMaxMm;
    copy.yMaxMm = yMaxMm;
    return copy;
  }

  /** Grows to contain {@code other}. */
  public void include(BoundingBox other) {
    xMinMm = Math.min(xMinMm, other.xMinMm);
    yMinMm = Math.min(yMinMm, other.yMinMm);
    xMaxMm = Math.max(xMaxMm, other.xMaxMm);
    yMaxMm = Math.max(yMaxMm, other.yMaxMm);
  }

  void add(Point point) {
    xMinMm = Math.min(xMinMm, point.xMm());
    yMinMm = Math.min(yMinMm, point.yMm());
    xMaxMm = Math.max(xMaxMm, point.xMm());
    yMaxMm = Math.max(yMaxMm, point.yMm());
  }

  private boolean isEmpty() {
    return xMinMm > xMaxMm;
  }

  public double widthMm() {
    return isEmpty() ? 0 : xMaxMm - xMinMm;
  }

  public double heightMm() {
    return isEmpty() ? 0 : yMaxMm - yMinMm;
  }

  Point centre() {
    return isEmpty() ? new Point(0, 0) : new Point((xMinMm + xMaxMm) / 2, (yMinMm + yMaxMm) / 2);
  }
}
