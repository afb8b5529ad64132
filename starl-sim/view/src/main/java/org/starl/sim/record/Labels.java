package org.starl.sim.record;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.trace.Instance;

/**
 * Writes names and locations of robots, where there is room: below, above, right or left of the
 * robot. Labels do not overlap; those without room are counted in the lower right corner.
 */
final class Labels {

  private static final Font NAME = new Font(Font.SANS_SERIF, Font.BOLD, 12);
  private static final Font PLACE = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
  private static final double LEAST_RADIUS_PX = 4;
  private static final int MANY = 150;
  private static final int MANY_PLACES = 40;
  private static final int LINE_PX = 14;

  /** From a body to its label; the ring of a selected robot fits in between. */
  private static final int GAP_PX = 6;

  private static final int MARGIN_PX = 12;

  private final Graphics2D page;
  private final Scene scene;
  private final Viewport viewport;
  private final Look look;
  private final List<Rectangle2D> bodies = new ArrayList<>();
  private final List<Rectangle2D> taken = new ArrayList<>();

  private Labels(Graphics2D page, Scene scene, Viewport viewport, Look look) {
    this.page = page;
    this.scene = scene;
    this.viewport = viewport;
    this.look = look;
  }

  /**
   * Paints the names.
   *
   * @param isCut whether robots outside of the viewport have none
   */
  static void paint(Graphics2D page, Scene scene, Viewport viewport, Look look, boolean isCut) {
    new Labels(page, scene, viewport, look).paint(isCut);
  }

  private void paint(boolean isCut) {
    List<RobotId> visible = new ArrayList<>();
    scene.forEachBody((robot, number, pose, radiusMm) -> {
      if (!isCut || viewport.shows(pose.at(), radiusMm)) {
        visible.add(robot);
      }
    });
    RobotId selected = look.selected();
    boolean hasSelected = selected != null && visible.remove(selected);
    if (hasSelected) {
      // It has the first choice of places.
      visible.add(0, selected);
    }
    List<RobotId> named =
        visible.size() <= MANY ? visible : visible.subList(0, hasSelected ? 1 : 0);
    named.forEach(robot -> bodies.add(body(robot)));
    int unnamed = 0;
    for (RobotId robot : named) {
      boolean isLarge = scene.radiusMm(robot) * viewport.pxPerMm() >= LEAST_RADIUS_PX;
      if ((isLarge || robot.equals(selected)) && !label(robot, visible.size() <= MANY_PLACES)) {
        unnamed++;
      }
    }
    if (unnamed > 0) {
      count(unnamed);
    }
  }

  private Rectangle2D body(RobotId robot) {
    Pose pose = scene.pose(robot).orElseThrow();
    double r = scene.radiusMm(robot) * viewport.pxPerMm();
    return new Rectangle2D.Double(
        viewport.xPx(pose.at()) - r, viewport.yPx(pose.at()) - r, 2 * r, 2 * r);
  }

  /** Returns false if there is no room. */
  private boolean label(RobotId robot, boolean hasLocations) {
    Rectangle2D body = body(robot);
    List<Line> lines = new ArrayList<>();
    if (look.shows(Part.NAMES)) {
      Line name = line(NAME, robot.name());
      if (name.widthPx() < 0.875 * body.getWidth()) {
        page.setFont(NAME);
        page.setColor(look.theme().ink());
        float left = (float) (body.getCenterX() - name.widthPx() / 2.0);
        page.drawString(robot.name(), left, (float) body.getCenterY() + 4);
      } else {
        lines.add(name);
      }
    }
    boolean isSelected = robot.equals(look.selected());
    String location = scene.text(robot, Instance.APP, "location");
    if (look.shows(Part.LOCATIONS) && (isSelected || hasLocations) && !location.isEmpty()) {
      lines.add(line(PLACE, location));
    }
    return lines.isEmpty() || place(lines, body);
  }

  private record Line(Font font, String text, int widthPx) {}

  private Line line(Font font, String text) {
    return new Line(font, text, page.getFontMetrics(font).stringWidth(text));
  }

  private boolean place(List<Line> lines, Rectangle2D body) {
    double width = lines.stream().mapToInt(Line::widthPx).max().orElseThrow();
    double height = (double) LINE_PX * lines.size();
    double across = body.getCenterX() - width / 2;
    double beside = body.getCenterY() - height / 2;
    List<Rectangle2D> places =
        List.of(
            new Rectangle2D.Double(across, body.getMaxY() + GAP_PX, width, height),
            new Rectangle2D.Double(across, body.getMinY() - GAP_PX - height, width, height),
            new Rectangle2D.Double(body.getMaxX() + GAP_PX, beside, width, height),
            new Rectangle2D.Double(body.getMinX() - GAP_PX - width, beside, width, height));
    Rectangle2D picture = new Rectangle2D.Double(0, 0, viewport.widthPx(), viewport.heightPx());
    List<Rectangle2D> apart = places.stream().filter(place -> isFree(place, taken)).toList();
    if (apart.isEmpty()) {
      return false;
    }
    Rectangle2D best =
        apart.stream()
            .filter(place -> picture.contains(place) && isFree(place, bodies))
            .findFirst()
            .orElse(apart.get(0));
    taken.add(best);
    double baseline = best.getY() + LINE_PX - 3;
    for (Line line : lines) {
      page.setFont(line.font());
      double left = best.getCenterX() - line.widthPx() / 2.0;
      haloed(page, line.text(), left, baseline, look.theme().ink(), look.theme().paper());
      baseline += LINE_PX;
    }
    return true;
  }

  private static boolean isFree(Rectangle2D place, List<Rectangle2D> others) {
    return others.stream().noneMatch(place::intersects);
  }

  private void count(int unnamed) {
    String text = unnamed + (unnamed == 1 ? " robot" : " robots") + " without room for a name";
    page.setFont(PLACE);
    FontMetrics metrics = page.getFontMetrics();
    double left = viewport.widthPx() - MARGIN_PX - metrics.stringWidth(text);
    Theme theme = look.theme();
    haloed(page, text, left, viewport.heightPx() - MARGIN_PX, theme.muted(), theme.paper());
  }

  /** Text with a halo, readable on any background. */
  static void haloed(Graphics2D page, String text, double x, double y, Color ink, Color paper) {
    page.setColor(Theme.faded(paper, 190));
    for (int dx = -1; dx <= 1; dx++) {
      for (int dy = -1; dy <= 1; dy++) {
        page.drawString(text, (float) x + dx, (float) y + dy);
      }
    }
    page.setColor(ink);
    page.drawString(text, (float) x, (float) y);
  }
}
