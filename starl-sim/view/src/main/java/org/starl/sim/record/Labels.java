package org.starl.sim.record;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Optional;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/** Writes robots' names, and where each is in its program, where there is room. */
final class Labels {

  private static final Font NAME = new Font(Font.SANS_SERIF, Font.BOLD, 12);
  private static final Font PLACE = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
  private static final double LEAST_RADIUS_PX = 4;
  private static final int MANY = 150;
  private static final int MANY_PLACES = 40;

  private Labels() {}

  static void paint(Graphics2D page, Scene scene, Viewport viewport, Look look, int shown) {
    RobotId selected = look.selected();
    List<RobotId> named =
        shown <= MANY ? scene.robots() : selected == null ? List.of() : List.of(selected);
    for (RobotId robot : named) {
      Optional<Pose> pose = scene.pose(robot);
      if (pose.isEmpty() || !viewport.shows(pose.get().at(), scene.radiusMm(robot))) {
        continue;
      }
      double radiusPx = scene.radiusMm(robot) * viewport.pxPerMm();
      boolean isSelected = robot.equals(selected);
      if (isSelected || radiusPx >= LEAST_RADIUS_PX) {
        double x = viewport.xPx(pose.get().at());
        double y = viewport.yPx(pose.get().at());
        double below = y + radiusPx + (isSelected ? 20 : 15);
        if (look.shows(Part.NAMES)) {
          below += name(page, robot, x, y, radiusPx, below, look);
        }
        if (look.shows(Part.LOCATIONS) && (isSelected || shown <= MANY_PLACES)) {
          page.setFont(PLACE);
          centred(page, scene.variable(robot, "app", "location"), x, below, look);
        }
      }
    }
  }

  /** Inside the disc if it fits, else below; returns how much lower the next line goes. */
  private static double name(
      Graphics2D page,
      RobotId robot,
      double x,
      double y,
      double radiusPx,
      double below,
      Look look) {
    page.setFont(NAME);
    int width = page.getFontMetrics().stringWidth(robot.name());
    if (width < 1.75 * radiusPx) {
      page.setColor(look.theme().ink());
      page.drawString(robot.name(), (float) (x - width / 2.0), (float) y + 4);
      return 0;
    }
    centred(page, robot.name(), x, below, look);
    return 14;
  }

  private static void centred(Graphics2D page, String text, double x, double y, Look look) {
    FontMetrics metrics = page.getFontMetrics();
    double left = x - metrics.stringWidth(text) / 2.0;
    haloed(page, text, left, y, look.theme().ink(), look.theme().paper());
  }

  /** Text that is readable on every background. */
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
