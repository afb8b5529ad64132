package org.starl.sim.record;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.starl.id.RobotId;

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

  /** The picture of {@code scene} in its present state. */
  BufferedImage paint(Scene scene, Layer layer, String title) {
    BufferedImage image =
        new BufferedImage(FLOOR_PX + LEGEND_PX, FLOOR_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setColor(look.theme().paper());
    page.fillRect(0, 0, image.getWidth(), image.getHeight());
    Viewport viewport = Viewport.fit(BoundingBox.of(scene, layer), FLOOR_PX, FLOOR_PX, MARGIN_PX);
    Graphics2D floor = (Graphics2D) page.create(0, 0, FLOOR_PX, FLOOR_PX);
    painter.paint(floor, scene, layer, viewport, look);
    page.setRenderingHints(floor.getRenderingHints());
    floor.dispose();
    legend(page, scene, layer, title);
    page.dispose();
    return image;
  }

  private void legend(Graphics2D page, Scene scene, Layer layer, String title) {
    int x = FLOOR_PX + MARGIN_PX / 2;
    int y = MARGIN_PX + LINE_PX;
    page.setColor(look.theme().ink());
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
    page.drawString(title, x, y);
    page.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
    // Robots on the floor come first.
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
