package org.starl.sim.record;

import java.awt.geom.AffineTransform;
import java.util.List;
import org.starl.geometry.Point;

/**
 * The part of the world that a picture shows, and its scale. The world's y axis points up, a
 * picture's y axis down.
 *
 * @param centre point of the world in the centre of the picture
 * @param pxPerMm scale, above 0; limited to 0.001 to 10
 */
public record Viewport(int widthPx, int heightPx, Point centre, double pxPerMm) {

  private static final double WORLD_MARGIN_MM = 150;

  private static final double LEAST_PX_PER_MM = 1e-3;

  private static final double MOST_PX_PER_MM = 10;

  public Viewport {
    if (widthPx < 1 || heightPx < 1 || !centre.isFinite() || !(pxPerMm > 0)) {
      throw new IllegalArgumentException(
          widthPx + "x" + heightPx + " px around " + centre + ", " + pxPerMm + " px/mm");
    }
    pxPerMm = Math.max(LEAST_PX_PER_MM, Math.min(MOST_PX_PER_MM, pxPerMm));
  }

  /** Shows all of {@code extent} with a margin. */
  public static Viewport fit(BoundingBox extent, int widthPx, int heightPx, int marginPx) {
    double across = Math.max(1, widthPx - 2 * marginPx) / (extent.widthMm() + 2 * WORLD_MARGIN_MM);
    double up = Math.max(1, heightPx - 2 * marginPx) / (extent.heightMm() + 2 * WORLD_MARGIN_MM);
    return new Viewport(widthPx, heightPx, extent.centre(), Math.min(across, up));
  }

  /** The corners of the smallest rectangle, in px, that contains this picture and {@code extent}. */
  public List<Double> box(BoundingBox extent) {
    double halfMm = WORLD_MARGIN_MM + extent.widthMm() / 2;
    double halfUpMm = WORLD_MARGIN_MM + extent.heightMm() / 2;
    double x = xPx(extent.centre());
    double y = yPx(extent.centre());
    return List.of(
        Math.min(0, x - halfMm * pxPerMm),
        Math.min(0, y - halfUpMm * pxPerMm),
        Math.max(widthPx, x + halfMm * pxPerMm),
        Math.max(heightPx, y + halfUpMm * pxPerMm));
  }

  /** The same centre and scale in a picture of another size. */
  public Viewport resized(int newWidthPx, int newHeightPx) {
    return new Viewport(newWidthPx, newHeightPx, centre, pxPerMm);
  }

  /** Moves the world by some pixels in the picture. */
  public Viewport panned(double rightPx, double downPx) {
    return around(centre.plus(new Point(-rightPx / pxPerMm, downPx / pxPerMm)));
  }

  /** The same scale with another point in the centre. */
  public Viewport around(Point newCentre) {
    return new Viewport(widthPx, heightPx, newCentre, pxPerMm);
  }

  /** Zooms in by {@code factor}; the point of the world at the given pixel stays there. */
  public Viewport zoomed(double factor, double xPx, double yPx) {
    Viewport larger = new Viewport(widthPx, heightPx, centre, pxPerMm * factor);
    Point before = toWorld(xPx, yPx);
    Point after = larger.toWorld(xPx, yPx);
    return larger.around(
        centre.plus(new Point(before.xMm() - after.xMm(), before.yMm() - after.yMm())));
  }

  public Point toWorld(double xPx, double yPx) {
    return new Point(
        centre.xMm() + (xPx - widthPx / 2.0) / pxPerMm,
        centre.yMm() - (yPx - heightPx / 2.0) / pxPerMm);
  }

  public double xPx(Point point) {
    return widthPx / 2.0 + (point.xMm() - centre.xMm()) * pxPerMm;
  }

  public double yPx(Point point) {
    return heightPx / 2.0 - (point.yMm() - centre.yMm()) * pxPerMm;
  }

  /** Whether a disc of {@code radiusMm} around {@code point} is at least partly in the picture. */
  public boolean shows(Point point, double radiusMm) {
    double x = xPx(point);
    double y = yPx(point);
    double r = radiusMm * pxPerMm;
    return x + r >= 0 && y + r >= 0 && x - r <= widthPx && y - r <= heightPx;
  }

  AffineTransform transform() {
    AffineTransform transform = new AffineTransform();
    transform.translate(widthPx / 2.0, heightPx / 2.0);
    transform.scale(pxPerMm, -pxPerMm);
    transform.translate(-centre.xMm(), -centre.yMm());
    return transform;
  }
}
