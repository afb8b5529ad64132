package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Optional;
import org.starl.geometry.Pose;

/**
 * Paints datagrams: an arc from sender to receiver in the sender's colour, and a moving dot on it.
 */
final class FlightPainter {

  private static final int FEW = 14;
  private static final int MANY = 80;
  private static final double BEND = 0.10;
  private static final double DOT_PX = 4.5;
  private static final double LEAST_DOT_PX = 2.5;
  private static final int MOST = 24;

  void paint(Graphics2D page, List<Flight> flights, Scene scene, Viewport viewport, Look look) {
    if (flights.size() > MANY) {
      plainly(page, flights, scene, viewport, look);
      return;
    }
    boolean areNamed = flights.size() <= FEW;
    for (Flight flight : flights) {
      Optional<Pose> from = scene.pose(flight.from());
      Optional<Pose> to = scene.pose(flight.to());
      if (from.isPresent() && to.isPresent() && !flight.from().equals(flight.to())) {
        Arc arc =
            Arc.between(
                viewport.xPx(from.get().at()),
                viewport.yPx(from.get().at()),
                scene.radiusMm(flight.from()) * viewport.pxPerMm(),
                viewport.xPx(to.get().at()),
                viewport.yPx(to.get().at()),
                scene.radiusMm(flight.to()) * viewport.pxPerMm());
        double robotPx = scene.radiusMm(flight.to()) * viewport.pxPerMm();
        double dotPx = Math.max(LEAST_DOT_PX, Math.min(DOT_PX, 0.3 * robotPx));
        Color colour = look.robot(scene, flight.from());
        paint(page, flight, arc, dotPx, colour, look.theme(), areNamed);
      }
    }
  }

  /** Straight lines, for too many datagrams to tell arcs apart. */
  private static void plainly(
      Graphics2D page, List<Flight> flights, Scene scene, Viewport viewport, Look look) {
    Object before = page.getRenderingHint(RenderingHints.KEY_ANTIALIASING);
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
    page.setStroke(new BasicStroke(1));
    for (Flight flight : flights) {
      Optional<Pose> from = scene.pose(flight.from());
      Optional<Pose> to = scene.pose(flight.to());
      if (from.isPresent() && to.isPresent()) {
        page.setColor(
            flight.state() == Flight.State.DROPPED
                ? look.theme().alarm()
                : look.robot(scene, flight.from()));
        page.drawLine(
            (int) viewport.xPx(from.get().at()),
            (int) viewport.yPx(from.get().at()),
            (int) viewport.xPx(to.get().at()),
            (int) viewport.yPx(to.get().at()));
      }
    }
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, before);
  }

  private static void paint(
      Graphics2D page,
      Flight flight,
      Arc arc,
      double dotPx,
      Color colour,
      Theme theme,
      boolean isNamed) {
    boolean isDropped = flight.state() == Flight.State.DROPPED;
    Color line = isDropped ? theme.alarm() : colour;
    page.setColor(Theme.faded(line, flight.state() == Flight.State.DELIVERED ? 150 : 95));
    page.setStroke(new BasicStroke(1.3f));
    page.draw(arc.path());
    double x = arc.x(flight.share());
    double y = arc.y(flight.share());
    if (isDropped) {
      page.setColor(theme.alarm());
      page.setStroke(new BasicStroke(2.2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
      Painter.cross(page, x, y, dotPx);
    } else {
      page.setColor(theme.paper());
      page.fill(Figures.disc(x, y, dotPx + 1));
      page.setColor(line);
      page.fill(Figures.disc(x, y, dotPx));
    }
    if (isNamed && flight.state() != Flight.State.DELIVERED) {
      page.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 11));
      String title = flight.title();
      String shown = title.length() > MOST ? title.substring(0, MOST - 1) + "\u2026" : title;
      Labels.haloed(page, shown, x + 8, y + 4, theme.ink(), theme.paper());
    }
  }

  /** Bent to one side, so that messages in opposite directions do not overlap. */
  private record Arc(double x0, double y0, double x1, double y1) {

    /** From edge to edge of two discs; from centre to centre if they are too close. */
    static Arc between(double x0, double y0, double r0, double x1, double y1, double r1) {
      double length = Math.sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0));
      if (length <= r0 + r1 + 4 * DOT_PX) {
        return new Arc(x0, y0, x1, y1);
      }
      double dx = (x1 - x0) / length;
      double dy = (y1 - y0) / length;
      return new Arc(x0 + r0 * dx, y0 + r0 * dy, x1 - r1 * dx, y1 - r1 * dy);
    }

    private double xBend() {
      return (x0 + x1) / 2 - BEND * (y1 - y0);
    }

    private double yBend() {
      return (y0 + y1) / 2 + BEND * (x1 - x0);
    }

    Path2D path() {
      Path2D path = new Path2D.Double();
      path.moveTo(x0, y0);
      path.quadTo(xBend(), yBend(), x1, y1);
      return path;
    }

    double x(double share) {
      return at(share, x0, xBend(), x1);
    }

    double y(double share) {
      return at(share, y0, yBend(), y1);
    }

    private static double at(double t, double a, double b, double c) {
      return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
    }
  }
}
