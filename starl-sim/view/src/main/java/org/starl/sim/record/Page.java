package org.starl.sim.record;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Nowhere;
import org.starl.id.RobotId;
import org.starl.sim.Failure;

/** A picture for a file: the floor on the left, a legend of the robots on the right. */
final class Page {

  private static final int FLOOR_PX = 900;
  private static final int LEGEND_PX = 520;
  private static final int MARGIN_PX = 24;
  private static final int LEAST_NAME_PX = 62;
  private static final int LINE_PX = 19;
  private static final int ENTRY_GAP_PX = 16;
  private static final int CARD_INSET_PX = 12;

  private final Painter painter = new Painter();
  private final Look look = Look.FILE;

  /**
   * The picture of {@code scene} in its present state. In place of a floor on which nothing has moved
   * and nothing is drawn, it shows the lanes.
   */
  BufferedImage paint(Scene scene, Layer layer, Lanes lanes, String title) {
    BufferedImage image =
        new BufferedImage(FLOOR_PX + LEGEND_PX, FLOOR_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setColor(look.theme().paper());
    page.fillRect(0, 0, image.getWidth(), image.getHeight());
    Viewport viewport = Viewport.fit(BoundingBox.of(scene, layer), FLOOR_PX, FLOOR_PX, MARGIN_PX);
    Graphics2D floor = (Graphics2D) page.create(0, 0, FLOOR_PX, FLOOR_PX);
    Failure failure = scene.failure();
    boolean isOfAPlace = failure != null && !(failure.region() instanceof Nowhere);
    if (layer == Layer.NONE && scene.isStill() && scene.nowNs() > 0 && !isOfAPlace) {
      Painter.smooth(floor);
      LanePainter time = new LanePainter(lanes, 0, scene.nowNs(), FLOOR_PX);
      time.paint(floor, look.theme());
      if (failure != null) {
        int x = (int) time.xPx(failure.atNs());
        floor.setColor(look.theme().alarm());
        floor.fillRect(x, 0, 2, FLOOR_PX);
      }
    } else {
      painter.paint(floor, scene, layer, viewport, look);
    }
    page.setRenderingHints(floor.getRenderingHints());
    floor.dispose();
    int bottomPx = card(page, failure);
    legend(page, scene, layer, title, bottomPx);
    page.dispose();
    return image;
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

  /** Describes what went wrong below the legend; returns where it begins. */
  private int card(Graphics2D page, @Nullable Failure failure) {
    if (failure == null) {
      return FLOOR_PX;
    }
    Font bold = new Font(Font.SANS_SERIF, Font.BOLD, 14);
    Font plain = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    int widthPx = LEGEND_PX - MARGIN_PX - CARD_INSET_PX;
    List<String> headline = wrapped(failure.headline(), page.getFontMetrics(bold), widthPx);
    List<String> lines = new ArrayList<>(headline);
    for (String line : failure.lines().subList(1, failure.lines().size())) {
      lines.addAll(wrapped(line, page.getFontMetrics(plain), widthPx));
    }
    int most = (FLOOR_PX / 2) / LINE_PX;
    if (lines.size() > most) {
      lines.subList(most - 1, lines.size()).clear();
      lines.add("\u2026");
    }
    int x = FLOOR_PX + MARGIN_PX / 2;
    int top = FLOOR_PX - MARGIN_PX - lines.size() * LINE_PX;
    page.setColor(look.theme().alarm());
    page.fillRect(x, top, 4, lines.size() * LINE_PX);
    for (int i = 0; i < lines.size(); i++) {
      boolean isHeadline = i < headline.size();
      page.setFont(isHeadline ? bold : plain);
      page.setColor(isHeadline ? look.theme().alarm() : look.theme().ink());
      page.drawString(lines.get(i), x + CARD_INSET_PX, top + i * LINE_PX + 14);
    }
    return top;
  }

  private void legend(Graphics2D page, Scene scene, Layer layer, String title, int bottomPx) {
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
      if (y + heightPx > bottomPx - LINE_PX && i + 1 < robots.size()) {
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
