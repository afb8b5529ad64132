package org.starl.sim.record;

import java.awt.geom.AffineTransform;
import org.starl.geometry.Point;

/**
 * Which part of the world a picture shows, and how large. The world's y points up, a picture's down.
 *
 * @param widthPx of the picture
 * @param heightPx of the picture
 * @param centre what is in the picture's middle
 * @param pxPerMm above 0
 */
public record Viewport(int widthPx, int heightPx, Point centre, double pxPerMm) {

  private static final double WORLD_MARGIN_MM = 150;

  /** From a metre that is a pixel to a millimetre that is ten. */
  private static final double LEAST_PX_PER_MM = 1e-3;

  private static final double MOST_PX_PER_MM = 10;

  public Viewport {
    if (widthPx < 1 || heightPx < 1 || !centre.isFinite() || !(pxPerMm > 0)) {
      throw new IllegalArgumentException(
          widthPx + "x" + heightPx + " px around " + centre + ", " + pxPerMm + " px/mm");
    }
    pxPerMm = Math.max(LEAST_PX_PER_MM, Math.min(MOST_PX_PER_MM, pxPerMm));
  }

  /** All of {@code extent}, and a little around it. */
  public static Viewport fit(Extent extent, int widthPx, int heightPx, int marginPx) {
    double across = Math.max(1, widthPx - 2 * marginPx) / (extent.widthMm() + 2 * WORLD_MARGIN_MM);
    double up = Math.max(1, heightPx - 2 * marginPx) / (extent.heightMm() + 2 * WORLD_MARGIN_MM);
    return new Viewport(widthPx, heightPx, extent.centre(), Math.min(across, up));
  }

  /** The same place in a picture of another size. */
  public Viewport resized(int newWidthPx, int newHeightPx) {
    return new Viewport(newWidthPx, newHeightPx, centre, pxPerMm);
  }

  /** The world is dragged by so many pixels. */
  public Viewport panned(double rightPx, double downPx) {
    return around(centre.plus(new Point(-rightPx / pxPerMm, downPx / pxPerMm)));
  }

  /** The same with another point in the middle. */
  public Viewport around(Point newCentre) {
    return new Viewport(widthPx, heightPx, newCentre, pxPerMm);
  }

  /** Larger by {@code factor}; what is under the pixel stays there. */
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

  /** Whether a disc of {@code radiusMm} around {@code point} is in the picture, if only in part. */
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
