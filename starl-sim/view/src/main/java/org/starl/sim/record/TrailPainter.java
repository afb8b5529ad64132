package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.id.RobotId;

/** Paints the trails of robots. */
final class TrailPainter {

  private static final double WIDTH_MM = 18;

  /** A point closer than this to the previous one is skipped. */
  private static final double STEP_PX = 1.2;

  /** With more robots, trails are thin and short. */
  private static final int MANY = 250;

  /** Greatest number of painted points in all, with many robots. */
  private static final int BUDGET = 40_000;

  private static final int MOST_POINTS = 1 << 14;

  /** Greatest number of points of all trails together: 8 MB in each checkpoint. */
  private static final int MOST_POINTS_IN_ALL = 1 << 19;

  private int[] xs = new int[64];
  private int[] ys = new int[64];

  /**
   * Greatest number of points that a trail keeps. With many robots, only the latest half of them is
   * painted; otherwise all are, unless the look has fewer.
   */
  static int mostPoints(int robots) {
    return robots > MANY
        ? 2 * painted(robots)
        : Math.min(MOST_POINTS, MOST_POINTS_IN_ALL / Math.max(1, robots));
  }

  private static int painted(int robots) {
    return Math.max(4, BUDGET / robots);
  }

  void paint(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    List<RobotId> robots = scene.robots();
    boolean isMany = robots.size() > MANY;
    int points = isMany ? Math.min(look.trailPoints(), painted(robots.size())) : look.trailPoints();
    Object before = page.getRenderingHint(RenderingHints.KEY_ANTIALIASING);
    if (isMany) {
      page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
      page.setStroke(new BasicStroke(1));
    } else {
      float widthPx = (float) Math.max(1.2, WIDTH_MM * viewport.pxPerMm());
      page.setStroke(new BasicStroke(widthPx, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    }
    for (RobotId robot : robots) {
      List<Point> trail = scene.trail(robot);
      int from = Math.max(0, trail.size() - points);
      if (trail.size() - from > 1) {
        page.setColor(look.robot(scene, robot));
        if (isMany) {
          thin(page, trail, from, viewport);
        } else {
          smooth(page, trail, from, viewport);
        }
      }
    }
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, before);
  }

  private static void smooth(Graphics2D page, List<Point> trail, int from, Viewport viewport) {
    Path2D path = new Path2D.Double();
    double lastX = viewport.xPx(trail.get(from));
    double lastY = viewport.yPx(trail.get(from));
    path.moveTo(lastX, lastY);
    for (int i = from + 1; i < trail.size(); i++) {
      double x = viewport.xPx(trail.get(i));
      double y = viewport.yPx(trail.get(i));
      boolean isLast = i == trail.size() - 1;
      if (isLast || Math.abs(x - lastX) + Math.abs(y - lastY) >= STEP_PX) {
        path.lineTo(x, y);
        lastX = x;
        lastY = y;
      }
    }
    page.draw(path);
  }

  private void thin(Graphics2D page, List<Point> trail, int from, Viewport viewport) {
    int count = trail.size() - from;
    if (count > xs.length) {
      xs = new int[2 * count];
      ys = new int[2 * count];
    }
    for (int i = 0; i < count; i++) {
      Point point = trail.get(from + i);
      xs[i] = (int) viewport.xPx(point);
      ys[i] = (int) viewport.yPx(point);
    }
    page.drawPolyline(xs, ys, count);
  }
}
