package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;

/** Paints one robot's body: a disc with a line that shows the heading. */
final class BodyPainter {

  private static final double HEADING_FROM = 0.62;
  private static final double EDGE_SHARE = 0.073;
  private static final int FILL_ALPHA = 150;

  private final Ellipse2D.Double disc = new Ellipse2D.Double();
  private final Line2D.Double line = new Line2D.Double();

  /** Coordinates are in pixels; y points down. */
  void paint(
      Graphics2D page,
      double xPx,
      double yPx,
      double radiusPx,
      double headingRad,
      Color colour,
      Theme theme) {
    disc.setFrame(xPx - radiusPx, yPx - radiusPx, 2 * radiusPx, 2 * radiusPx);
    page.setColor(Theme.faded(colour, FILL_ALPHA));
    page.fill(disc);
    page.setColor(theme.edge(colour));
    page.setStroke(new BasicStroke((float) Math.max(1, EDGE_SHARE * radiusPx)));
    page.draw(disc);
    // A large disc contains the robot's name: the line begins outside of it.
    double cos = StrictMath.cos(headingRad);
    double sin = -StrictMath.sin(headingRad);
    double innerPx = radiusPx < 14 ? 0 : HEADING_FROM * radiusPx;
    line.setLine(
        xPx + innerPx * cos, yPx + innerPx * sin, xPx + radiusPx * cos, yPx + radiusPx * sin);
    page.draw(line);
  }

  /** Marks a robot whose program has crashed. */
  void paintCross(Graphics2D page, double xPx, double yPx, double radiusPx, Theme theme) {
    page.setColor(theme.alarm());
    page.setStroke(
        new BasicStroke(
            (float) Math.max(1.5, 0.14 * radiusPx), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    Painter.cross(page, xPx, yPx, 0.9 * radiusPx);
  }

  /** Marks the selected robot. */
  void paintRing(Graphics2D page, double xPx, double yPx, double radiusPx, Theme theme) {
    double ringPx = radiusPx + 5;
    disc.setFrame(xPx - ringPx, yPx - ringPx, 2 * ringPx, 2 * ringPx);
    page.setColor(theme.paper());
    page.setStroke(new BasicStroke(5));
    page.draw(disc);
    page.setColor(theme.ink());
    page.setStroke(new BasicStroke(2));
    page.draw(disc);
  }
}
