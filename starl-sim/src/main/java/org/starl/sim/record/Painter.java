package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.starl.RobotId;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;

/** Paints a {@link Scene}: the floor on the left, a line for each robot on the right. */
public final class Painter {

  private static final int FLOOR_PX = 900;
  private static final int LEGEND_PX = 520;
  private static final int MARGIN_PX = 24;
  private static final int LEAST_NAME_PX = 62;
  private static final int LINE_PX = 19;
  private static final int ENTRY_GAP_PX = 16;
  private static final double WORLD_MARGIN_MM = 150;
  private static final double HEADING_FROM = 0.62;

  private static final Color PAPER = new Color(0xFA, 0xFA, 0xF7);
  private static final Color INK = new Color(0x22, 0x22, 0x22);
  private static final Color WALL = new Color(0x55, 0x55, 0x55);
  private static final Color HIDDEN = new Color(0xB0, 0x40, 0x20);

  // Twelve hues that can be told apart on paper (after Tol's and Okabe and Ito's palettes).
  private static final int[] HUES = {
    0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9,
    0x882255, 0x117733, 0x999933, 0x332288, 0xAA4499, 0x44AA99
  };

  private final Layer layer;

  public Painter(Layer layer) {
    this.layer = layer;
  }

  /** The colour of a robot by its {@link Scene#number}. */
  public static Color colour(int number) {
    return new Color(HUES[number % HUES.length]);
  }

  /** The picture of {@code scene} as it is now. */
  public BufferedImage paint(Scene scene, String title) {
    BufferedImage image =
        new BufferedImage(FLOOR_PX + LEGEND_PX, FLOOR_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    page.setColor(PAPER);
    page.fillRect(0, 0, image.getWidth(), image.getHeight());
    Extent extent = Extent.of(scene, layer);
    Graphics2D floor = (Graphics2D) page.create(0, 0, FLOOR_PX, FLOOR_PX);
    AffineTransform toPixels = extent.toPixels(FLOOR_PX, MARGIN_PX, WORLD_MARGIN_MM);
    floor.transform(toPixels);
    paintFloor(floor, scene);
    floor.dispose();
    names(page, scene, toPixels);
    legend(page, scene, title);
    page.dispose();
    return image;
  }

  private void paintFloor(Graphics2D floor, Scene scene) {
    layer.paintFloor(floor, scene);
    for (Obstacle obstacle : scene.obstacles().standingAt(scene.nowNs()).all()) {
      floor.setColor(obstacle.hidden() ? HIDDEN : WALL);
      floor.setStroke(new BasicStroke(14));
      Path2D outline = outline(obstacle);
      if (obstacle.closed()) {
        floor.fill(outline);
      }
      floor.draw(outline);
    }
    for (RobotId robot : layer.showsTrails() ? scene.robots() : List.<RobotId>of()) {
      trail(floor, scene.trail(robot), colour(scene.number(robot)));
    }
    for (RobotId robot : scene.robots()) {
      Optional<Pose> pose = scene.pose(robot);
      if (pose.isPresent()) {
        body(floor, pose.get(), scene.radiusMm(robot), colour(scene.number(robot)));
      }
    }
    layer.paintOver(floor, scene);
  }

  private static void trail(Graphics2D floor, List<Point> points, Color colour) {
    if (points.isEmpty()) {
      return;
    }
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).xMm(), points.get(0).yMm());
    for (Point point : points) {
      path.lineTo(point.xMm(), point.yMm());
    }
    floor.setColor(colour);
    floor.setStroke(new BasicStroke(18, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    floor.draw(path);
  }

  private static void body(Graphics2D floor, Pose pose, double radiusMm, Color colour) {
    Shape disc =
        new Ellipse2D.Double(
            pose.xMm() - radiusMm, pose.yMm() - radiusMm, 2 * radiusMm, 2 * radiusMm);
    floor.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 150));
    floor.fill(disc);
    floor.setColor(colour.darker());
    floor.setStroke(new BasicStroke(12));
    floor.draw(disc);
    // From outside the name to the edge.
    double cos = StrictMath.cos(pose.headingRad());
    double sin = StrictMath.sin(pose.headingRad());
    double innerMm = HEADING_FROM * radiusMm;
    floor.draw(
        new Line2D.Double(
            pose.xMm() + innerMm * cos,
            pose.yMm() + innerMm * sin,
            pose.xMm() + radiusMm * cos,
            pose.yMm() + radiusMm * sin));
  }

  private static Path2D outline(Obstacle obstacle) {
    Path2D path = new Path2D.Double();
    List<Point> points = obstacle.points();
    path.moveTo(points.get(0).xMm(), points.get(0).yMm());
    for (Point point : points) {
      path.lineTo(point.xMm(), point.yMm());
    }
    if (obstacle.closed()) {
      path.closePath();
    }
    return path;
  }

  private static void names(Graphics2D page, Scene scene, AffineTransform toPixels) {
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 12));
    page.setColor(INK);
    for (RobotId robot : scene.robots()) {
      Optional<Pose> pose = scene.pose(robot);
      if (pose.isPresent()) {
        Point2D at =
            toPixels.transform(new Point2D.Double(pose.get().xMm(), pose.get().yMm()), null);
        int halfWidth = page.getFontMetrics().stringWidth(robot.name()) / 2;
        page.drawString(robot.name(), (int) at.getX() - halfWidth, (int) at.getY() + 4);
      }
    }
  }

  private void legend(Graphics2D page, Scene scene, String title) {
    int x = FLOOR_PX + MARGIN_PX / 2;
    int y = MARGIN_PX + LINE_PX;
    page.setColor(INK);
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
    page.drawString(title, x, y);
    page.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
    // Who is there comes first.
    List<RobotId> robots = new ArrayList<>(scene.robots());
    robots.sort(Comparator.comparing(robot -> scene.pose(robot).isEmpty()));
    y += LINE_PX + ENTRY_GAP_PX;
    int namePx = LEAST_NAME_PX;
    for (RobotId robot : robots) {
      namePx = Math.max(namePx, page.getFontMetrics().stringWidth(robot.name() + "  "));
    }
    for (int i = 0; i < robots.size(); i++) {
      List<String> lines = layer.describe(robots.get(i), scene).lines().toList();
      int heightPx = Math.max(1, lines.size()) * LINE_PX + ENTRY_GAP_PX;
      if (y + heightPx > FLOOR_PX - LINE_PX && i + 1 < robots.size()) {
        page.setColor(INK);
        page.drawString("and " + (robots.size() - i) + " more", x, y);
        return;
      }
      page.setColor(colour(scene.number(robots.get(i))));
      page.fillOval(x, y - 10, 11, 11);
      page.setColor(INK);
      page.drawString(robots.get(i).name(), x + 18, y);
      for (int line = 0; line < lines.size(); line++) {
        page.drawString(lines.get(line), x + 18 + namePx, y + line * LINE_PX);
      }
      y += heightPx;
    }
  }
}
