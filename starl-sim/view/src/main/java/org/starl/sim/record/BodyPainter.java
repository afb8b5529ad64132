package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;

/** Paints one robot's body: a disc with a line towards where it heads. */
final class BodyPainter {

  private static final double HEADING_FROM = 0.62;
  private static final double EDGE_SHARE = 0.073;
  private static final int FILL_ALPHA = 150;

  private final Ellipse2D.Double disc = new Ellipse2D.Double();
  private final Line2D.Double line = new Line2D.Double();

  /** In pixels; y points down. */
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
    // From outside the name to the edge; from the middle where there is no room for a name.
    double cos = StrictMath.cos(headingRad);
    double sin = -StrictMath.sin(headingRad);
    double innerPx = radiusPx < 14 ? 0 : HEADING_FROM * radiusPx;
    line.setLine(
        xPx + innerPx * cos, yPx + innerPx * sin, xPx + radiusPx * cos, yPx + radiusPx * sin);
    page.draw(line);
  }

  /** Drawn over a robot whose program has crashed. */
  void paintCross(Graphics2D page, double xPx, double yPx, double radiusPx, Theme theme) {
    double arm = 0.9 * radiusPx;
    page.setColor(theme.alarm());
    page.setStroke(
        new BasicStroke(
            (float) Math.max(1.5, 0.14 * radiusPx), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    line.setLine(xPx - arm, yPx - arm, xPx + arm, yPx + arm);
    page.draw(line);
    line.setLine(xPx - arm, yPx + arm, xPx + arm, yPx - arm);
    page.draw(line);
  }

  /** Around the one that the picture is about. */
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
