package org.starl.sim.record;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** Shapes to draw, and text on a floor, for painters and {@link Layer}s. */
public final class Figures {

  private Figures() {}

  public static Line2D line(Point from, Point to) {
    return new Line2D.Double(from.xMm(), from.yMm(), to.xMm(), to.yMm());
  }

  /** A line through at least one point; with a round pen, one of one point is a disc. */
  public static Path2D line(List<Point> points) {
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).xMm(), points.get(0).yMm());
    points.forEach(point -> path.lineTo(point.xMm(), point.yMm()));
    return path;
  }

  /** A closed polygon. */
  public static Path2D polygon(List<Point> corners) {
    Path2D path = line(corners);
    path.closePath();
    return path;
  }

  /** A closed polygon; x and y alternate. */
  public static Path2D polygon(double... xy) {
    Path2D path = new Path2D.Double();
    path.moveTo(xy[0], xy[1]);
    for (int i = 2; i < xy.length; i += 2) {
      path.lineTo(xy[i], xy[i + 1]);
    }
    path.closePath();
    return path;
  }

  public static Ellipse2D disc(Point centre, double radiusMm) {
    return disc(centre.xMm(), centre.yMm(), radiusMm);
  }

  static Ellipse2D disc(double x, double y, double radius) {
    return new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
  }

  public static Rectangle2D rectangle(Rectangle area) {
    double widthMm = area.xMaxMm() - area.xMinMm();
    double heightMm = area.yMaxMm() - area.yMinMm();
    return new Rectangle2D.Double(area.xMinMm(), area.yMinMm(), widthMm, heightMm);
  }

  /** Writes a text from this point on, upright although the floor's y axis points up. */
  public static void text(Graphics2D floor, String text, Font font, double xMm, double yMm) {
    Graphics2D upright = (Graphics2D) floor.create();
    upright.transform(AffineTransform.getScaleInstance(1, -1));
    upright.setFont(font);
    upright.drawString(text, (float) xMm, (float) -yMm);
    upright.dispose();
  }
}
