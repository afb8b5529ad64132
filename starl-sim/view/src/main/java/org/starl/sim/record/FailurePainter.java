package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.sim.Failure;

/** Marks what went wrong: its zone, its robots, and where robots believe to be. */
final class FailurePainter {

  private static final double LEAST_SHOWN_MM = 5;

  private FailurePainter() {}

  /** Marks the zone and the robots of the scene's failure, if it has one now. */
  static void paint(Graphics2D page, Scene scene, Viewport viewport, Theme theme) {
    Failure failure = scene.failure();
    if (failure == null) {
      return;
    }
    Shape region = viewport.transform().createTransformedShape(shape(failure.region()));
    page.setColor(Theme.faded(theme.alarm(), 50));
    page.fill(region);
    page.setColor(theme.alarm());
    page.setStroke(new BasicStroke(3));
    page.draw(region);
    for (RobotId robot : failure.robots()) {
      scene
          .pose(robot)
          .ifPresent(pose ->
              page.draw(disc(viewport, pose.at(), scene.radiusMm(robot) * viewport.pxPerMm() + 6)));
    }
  }

  /** A dashed outline where a robot believes to be, with its error bound as a circle. */
  static void paintBeliefs(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      Deviation deviation = scene.variable(robot, Deviation.SOURCE, Deviation.VAR);
      if (deviation != null
          && (deviation.distanceMm() > LEAST_SHOWN_MM || deviation.errorMm() > LEAST_SHOWN_MM)) {
        Color edge = look.theme().edge(look.theme().robot(number));
        paintBelief(page, viewport, pose, deviation, radiusMm, edge);
      }
    });
  }

  private static void paintBelief(
      Graphics2D page,
      Viewport viewport,
      Pose truth,
      Deviation deviation,
      double radiusMm,
      Color colour) {
    Pose believed = deviation.believed(truth);
    double x = viewport.xPx(believed.at());
    double y = viewport.yPx(believed.at());
    double radiusPx = radiusMm * viewport.pxPerMm();
    page.setColor(colour);
    float[] dots = {1, 4};
    page.setStroke(
        new BasicStroke(1.2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 10, dots, 0));
    page.draw(new Line2D.Double(viewport.xPx(truth.at()), viewport.yPx(truth.at()), x, y));
    page.draw(disc(viewport, believed.at(), deviation.errorMm() * viewport.pxPerMm()));
    float[] dashes = {6, 4};
    page.setStroke(
        new BasicStroke(1.8f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dashes, 0));
    page.draw(disc(viewport, believed.at(), radiusPx));
    page.draw(
        new Line2D.Double(
            x,
            y,
            x + radiusPx * StrictMath.cos(believed.headingRad()),
            y - radiusPx * StrictMath.sin(believed.headingRad())));
  }

  private static Ellipse2D disc(Viewport viewport, Point centre, double radiusPx) {
    return Figures.disc(viewport.xPx(centre), viewport.yPx(centre), radiusPx);
  }

  /** In mm; empty if it has no border. */
  private static Path2D shape(Region region) {
    Path2D path = new Path2D.Double();
    switch (region) {
      case Circle circle -> path.append(Figures.disc(circle.center(), circle.radiusMm()), false);
      case Rectangle rectangle -> path.append(Figures.rectangle(rectangle), false);
      case Polygon polygon -> path.append(Figures.polygon(polygon.vertices()), false);
      case Union union -> union.parts().forEach(part -> path.append(shape(part), false));
      case Nowhere nowhere -> {
        // Nothing to mark.
      }
      case Everywhere everywhere -> {
        // It has no border.
      }
    }
    return path;
  }
}
