package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.id.RobotId;
import org.starl.spec.SpecReport.Violation;

/** A picture for a file: the floor on the left, a legend of the robots on the right. */
final class Page {

  private static final int FLOOR_PX = 900;
  private static final int LEGEND_PX = 520;
  private static final int MARGIN_PX = 24;
  private static final int LEAST_NAME_PX = 62;
  private static final int LINE_PX = 19;
  private static final int ENTRY_GAP_PX = 16;

  private final Painter painter = new Painter();
  private final Look look = Look.FILE;
  private Viewport viewport = Viewport.fit(new BoundingBox(), FLOOR_PX, FLOOR_PX, MARGIN_PX);

  /** The picture of {@code scene} in its present state. */
  BufferedImage paint(Scene scene, Layer layer, String title) {
    BufferedImage image =
        new BufferedImage(FLOOR_PX + LEGEND_PX, FLOOR_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setColor(look.theme().paper());
    page.fillRect(0, 0, image.getWidth(), image.getHeight());
    viewport = Viewport.fit(BoundingBox.of(scene, layer), FLOOR_PX, FLOOR_PX, MARGIN_PX);
    Graphics2D floor = (Graphics2D) page.create(0, 0, FLOOR_PX, FLOOR_PX);
    painter.paint(floor, scene, layer, viewport, look);
    page.setRenderingHints(floor.getRenderingHints());
    floor.dispose();
    legend(page, scene, layer, title);
    page.dispose();
    return image;
  }

  /**
   * Marks a violation in the picture that was painted last: the region, the robots, and the text
   * below.
   */
  void mark(BufferedImage image, Scene scene, Violation violation) {
    Graphics2D page = image.createGraphics();
    page.setClip(0, 0, FLOOR_PX, FLOOR_PX);
    Painter.smooth(page);
    page.setColor(Theme.faded(look.theme().alarm(), 50));
    Shape region = viewport.transform().createTransformedShape(shape(violation.region()));
    page.fill(region);
    page.setColor(look.theme().alarm());
    page.setStroke(new BasicStroke(3));
    page.draw(region);
    for (RobotId robot : violation.robots()) {
      scene
          .pose(robot)
          .ifPresent(pose -> {
            double ringPx = scene.radiusMm(robot) * viewport.pxPerMm() + 6;
            double x = viewport.xPx(pose.at()) - ringPx;
            double y = viewport.yPx(pose.at()) - ringPx;
            page.draw(new Ellipse2D.Double(x, y, 2 * ringPx, 2 * ringPx));
          });
    }
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
    List<String> lines =
        wrapped(violation.toString(), page.getFontMetrics(), FLOOR_PX - 2 * MARGIN_PX);
    int top = FLOOR_PX - MARGIN_PX / 2 - lines.size() * LINE_PX;
    page.setColor(look.theme().paper());
    page.fillRect(0, top - 4, FLOOR_PX, FLOOR_PX - top + 4);
    page.setColor(look.theme().alarm());
    for (int i = 0; i < lines.size(); i++) {
      page.drawString(lines.get(i), MARGIN_PX, top + i * LINE_PX + 14);
    }
    page.dispose();
  }

  /** In mm; empty if it has no border. */
  private static Path2D shape(Region region) {
    Path2D path = new Path2D.Double();
    switch (region) {
      case Circle circle -> {
        Point center = circle.center();
        double r = circle.radiusMm();
        path.append(new Ellipse2D.Double(center.xMm() - r, center.yMm() - r, 2 * r, 2 * r), false);
      }
      case Rectangle r ->
          path.append(
              new Rectangle2D.Double(
                  r.xMinMm(), r.yMinMm(), r.xMaxMm() - r.xMinMm(), r.yMaxMm() - r.yMinMm()),
              false);
      case Polygon polygon -> {
        path.moveTo(polygon.vertices().get(0).xMm(), polygon.vertices().get(0).yMm());
        polygon.vertices().forEach(vertex -> path.lineTo(vertex.xMm(), vertex.yMm()));
        path.closePath();
      }
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

  /** The text in lines of at most this width; longer words are divided. */
  private static List<String> wrapped(String text, FontMetrics font, int widthPx) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : text.split(" ", -1)) {
      if (line.length() > 0 && font.stringWidth(line + " " + word) > widthPx) {
        lines.add(line.toString());
        line.setLength(0);
      }
      line.append(line.length() == 0 ? "" : " ").append(word);
      while (font.stringWidth(line.toString()) > widthPx) {
        int end = line.length() - 1;
        while (font.stringWidth(line.substring(0, end)) > widthPx) {
          end--;
        }
        lines.add(line.substring(0, end));
        line.delete(0, end);
      }
    }
    lines.add(line.toString());
    return lines;
  }

  private void legend(Graphics2D page, Scene scene, Layer layer, String title) {
    int x = FLOOR_PX + MARGIN_PX / 2;
    int y = MARGIN_PX + LINE_PX;
    page.setColor(look.theme().ink());
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
    for (String line : wrapped(title, page.getFontMetrics(), LEGEND_PX - MARGIN_PX)) {
      page.drawString(line, x, y);
      y += LINE_PX;
    }
    page.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
    // Robots on the floor come first.
    List<RobotId> robots = new ArrayList<>(scene.robots());
    robots.sort(Comparator.comparing(robot -> scene.pose(robot).isEmpty()));
    y += ENTRY_GAP_PX;
    int namePx = LEAST_NAME_PX;
    for (RobotId robot : robots) {
      namePx = Math.max(namePx, page.getFontMetrics().stringWidth(robot.name() + "  "));
    }
    for (int i = 0; i < robots.size(); i++) {
      List<String> lines = layer.describe(robots.get(i), scene).lines().toList();
      int heightPx = Math.max(1, lines.size()) * LINE_PX + ENTRY_GAP_PX;
      if (y + heightPx > FLOOR_PX - LINE_PX && i + 1 < robots.size()) {
        page.setColor(look.theme().ink());
        page.drawString("and " + (robots.size() - i) + " more", x, y);
        return;
      }
      page.setColor(look.robot(scene, robots.get(i)));
      page.fillOval(x, y - 10, 11, 11);
      page.setColor(look.theme().ink());
      page.drawString(robots.get(i).name(), x + 18, y);
      for (int line = 0; line < lines.size(); line++) {
        page.drawString(lines.get(line), x + 18 + namePx, y + line * LINE_PX);
      }
      y += heightPx;
    }
  }
}
