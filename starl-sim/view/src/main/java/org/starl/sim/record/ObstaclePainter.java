package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;

/** Paints obstacles; caches the picture of many. */
final class ObstaclePainter {

  private static final int MANY = 150;
  private static final double LINE_MM = 14;

  /** Key of the cached picture. Obstacles only disappear, so their count identifies the set. */
  private record Key(
      Viewport viewport, Theme theme, boolean walls, boolean hidden, int count, double scale) {}

  private @Nullable Key key;
  private @Nullable BufferedImage kept;
  private final boolean hasCache;

  ObstaclePainter(boolean hasCache) {
    this.hasCache = hasCache;
  }

  void paint(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    Obstacles standing = scene.obstacles().standingAt(scene.nowNs());
    if (!hasCache || standing.all().size() < MANY) {
      draw(page, standing, viewport, look);
      return;
    }
    double scale = page.getTransform().getScaleX();
    Key wanted =
        new Key(
            viewport,
            look.theme(),
            look.shows(Part.WALLS),
            look.shows(Part.HIDDEN),
            standing.all().size(),
            scale);
    BufferedImage image = kept;
    if (image == null || !wanted.equals(key)) {
      image = picture(standing, viewport, look, scale);
      kept = image;
      key = wanted;
    }
    page.drawImage(image, 0, 0, viewport.widthPx(), viewport.heightPx(), null);
  }

  private static BufferedImage picture(
      Obstacles standing, Viewport viewport, Look look, double scale) {
    BufferedImage image =
        new BufferedImage(
            (int) Math.ceil(viewport.widthPx() * scale),
            (int) Math.ceil(viewport.heightPx() * scale),
            BufferedImage.TYPE_INT_ARGB_PRE);
    Graphics2D page = image.createGraphics();
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.scale(scale, scale);
    draw(page, standing, viewport, look);
    page.dispose();
    return image;
  }

  private static void draw(Graphics2D page, Obstacles standing, Viewport viewport, Look look) {
    Graphics2D floor = (Graphics2D) page.create();
    floor.transform(viewport.transform());
    BasicStroke stroke = look.line(LINE_MM);
    floor.setStroke(new BasicStroke(stroke.getLineWidth()));
    for (Obstacle obstacle : standing.all()) {
      if (look.shows(obstacle.hidden() ? Part.HIDDEN : Part.WALLS)) {
        Color colour = obstacle.hidden() ? look.theme().hidden() : look.theme().wall();
        floor.setColor(colour);
        Path2D outline = outline(obstacle);
        if (obstacle.closed()) {
          floor.fill(outline);
        }
        floor.draw(outline);
      }
    }
    floor.dispose();
  }

  private static Path2D outline(Obstacle obstacle) {
    return obstacle.closed() ? Figures.polygon(obstacle.points()) : Figures.line(obstacle.points());
  }
}
