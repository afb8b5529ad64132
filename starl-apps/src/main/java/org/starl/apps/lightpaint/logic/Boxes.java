package org.starl.apps.lightpaint.logic;

import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** Upright rectangles around things. */
public final class Boxes {

  private Boxes() {}

  /** The smallest one that holds all of {@code points}, at least one. */
  public static Rectangle around(List<Point> points) {
    double xMin = Double.POSITIVE_INFINITY;
    double yMin = Double.POSITIVE_INFINITY;
    double xMax = Double.NEGATIVE_INFINITY;
    double yMax = Double.NEGATIVE_INFINITY;
    for (Point point : points) {
      xMin = Math.min(xMin, point.xMm());
      yMin = Math.min(yMin, point.yMm());
      xMax = Math.max(xMax, point.xMm());
      yMax = Math.max(yMax, point.yMm());
    }
    return new Rectangle(xMin, yMin, xMax, yMax);
  }

  /** Wider by {@code byMm} on each side. */
  public static Rectangle widened(Rectangle box, double byMm) {
    return new Rectangle(
        box.xMinMm() - byMm, box.yMinMm() - byMm, box.xMaxMm() + byMm, box.yMaxMm() + byMm);
  }
}
