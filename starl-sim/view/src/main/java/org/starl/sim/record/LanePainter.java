package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Map;
import org.starl.id.RobotId;
import org.starl.sim.record.Lanes.Change;
import org.starl.sim.record.Lanes.Lane;
import org.starl.sim.record.Lanes.Tone;
import org.starl.time.Time;

/**
 * Paints {@link Lanes}: names on the left, time to the right.
 *
 * @param fromNs time at the left end
 * @param toNs time at the right end
 * @param widthPx of the names and the lanes
 */
public record LanePainter(Lanes lanes, long fromNs, long toNs, int widthPx) {

  /** Width of the names. */
  public static final int NAMES_PX = 132;

  private static final int ROW_PX = 15;
  private static final int GAP_PX = 7;
  private static final int STATE_ALPHA = 70;
  private static final int SIDE_PX = 16;
  private static final double LEAST_STATE_PX = 0.5;

  /** The height of a robot's lanes. */
  public int heightPx(RobotId robot) {
    return (1 + lanes.of(robot).size()) * ROW_PX + GAP_PX;
  }

  /** The height of the lanes of all robots. */
  public int heightPx() {
    return lanes.robots().stream().mapToInt(this::heightPx).sum();
  }

  /** The place of a time. */
  public double xPx(long timeNs) {
    double share = (double) (timeNs - fromNs) / Math.max(1, toNs - fromNs);
    return NAMES_PX + share * (widthPx - NAMES_PX - SIDE_PX);
  }

  /** The time at a place, within the ends. */
  public long timeNs(double xPx) {
    double share = (xPx - NAMES_PX) / (widthPx - NAMES_PX - SIDE_PX);
    return fromNs + (long) (Math.max(0, Math.min(1, share)) * (toNs - fromNs));
  }

  /** Paints the lanes of all robots, from the top of {@code page} on. */
  public void paint(Graphics2D page, Theme theme) {
    Graphics2D block = (Graphics2D) page.create();
    for (RobotId robot : lanes.robots()) {
      paint(block, robot, theme);
      block.translate(0, heightPx(robot));
    }
    key(block, theme);
    block.dispose();
  }

  /** The times of both ends, and the colours of states. */
  private void key(Graphics2D page, Theme theme) {
    page.setColor(theme.muted());
    page.drawString(Time.text(fromNs, 1), NAMES_PX, ROW_PX - 4);
    String end = Time.text(toNs, 1);
    int endPx = page.getFontMetrics().stringWidth(end);
    page.drawString(end, (float) xPx(toNs) - endPx, ROW_PX - 4);
    int x = NAMES_PX;
    int y = 2 * ROW_PX;
    for (String word : lanes.words()) {
      int wordPx = page.getFontMetrics().stringWidth(word) + 10;
      if (x + wordPx > xPx(toNs)) {
        x = NAMES_PX;
        y += ROW_PX;
      }
      page.setColor(Theme.faded(theme.robot(lanes.colour(word)), STATE_ALPHA));
      page.fill(new Rectangle2D.Double(x, y + 1, wordPx - 4, ROW_PX - 2));
      page.setColor(theme.ink());
      page.drawString(word, x + 3, y + ROW_PX - 4);
      x += wordPx;
    }
  }

  /** Paints the lanes of a robot, from the top of {@code page} on. */
  public void paint(Graphics2D page, RobotId robot, Theme theme) {
    Color colour = theme.robot(lanes.number(robot));
    page.setColor(theme.edge(colour));
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 12));
    page.drawString(robot.name(), 4, ROW_PX - 3);
    page.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 10));
    int y = ROW_PX;
    for (Map.Entry<String, Lane> entry : lanes.of(robot).entrySet()) {
      page.setColor(theme.muted());
      page.drawString(cut(page, entry.getKey(), NAMES_PX - 14), 10, y + ROW_PX - 4);
      switch (entry.getValue().kind()) {
        case STATES -> states(page, entry.getValue().changes(), y, theme);
        case CURVE -> curve(page, entry.getValue().changes(), y, colour);
        case INSTANTS -> instants(page, entry.getValue().changes(), y, theme);
      }
      y += ROW_PX;
    }
  }

  private void states(Graphics2D page, List<Change> changes, int y, Theme theme) {
    for (int i = 0; i < changes.size(); i++) {
      Change state = changes.get(i);
      double x = Math.max(NAMES_PX, xPx(state.timeNs()));
      double end =
          Math.min(
              xPx(toNs), i + 1 < changes.size() ? xPx(changes.get(i + 1).timeNs()) : xPx(toNs));
      if (end - x >= LEAST_STATE_PX && !state.text().isEmpty()) {
        Color colour = theme.robot(lanes.colour(state.text()));
        page.setColor(Theme.faded(colour, STATE_ALPHA));
        page.fill(new Rectangle2D.Double(x, y + 1, end - x, ROW_PX - 2));
        page.setColor(theme.ink());
        page.drawString(cut(page, state.text(), end - x - 6), (float) x + 3, y + ROW_PX - 4);
      }
    }
  }

  /** Each value stays until the next; the highest is at the top. */
  private void curve(Graphics2D page, List<Change> changes, int y, Color colour) {
    double least = changes.stream().mapToDouble(Change::value).min().orElse(0);
    double most = changes.stream().mapToDouble(Change::value).max().orElse(0);
    Path2D line = new Path2D.Double();
    double lastY = 0;
    for (Change change : changes) {
      double x = Math.max(NAMES_PX, Math.min(xPx(toNs), xPx(change.timeNs())));
      double share = most > least ? (change.value() - least) / (most - least) : 0.5;
      double nextY = y + ROW_PX - 3 - share * (ROW_PX - 5);
      if (line.getCurrentPoint() == null) {
        line.moveTo(x, nextY);
      } else {
        line.lineTo(x, lastY);
        line.lineTo(x, nextY);
      }
      lastY = nextY;
    }
    if (!changes.isEmpty()) {
      line.lineTo(xPx(toNs), lastY);
      page.setColor(colour);
      page.setStroke(new BasicStroke(1.2f));
      page.draw(line);
    }
  }

  /** Instants in the same place are painted once for each tone. */
  private void instants(Graphics2D page, List<Change> changes, int y, Theme theme) {
    page.setStroke(new BasicStroke(1));
    for (Tone tone : Tone.values()) {
      double top = y + (tone == Tone.GOOD ? ROW_PX / 2.0 : 2);
      double bottom = y + (tone == Tone.PLAIN ? ROW_PX / 2.0 : ROW_PX - 2);
      Path2D lines = new Path2D.Double();
      double last = 0;
      for (Change change : changes) {
        double x = Math.round(xPx(change.timeNs()));
        if (change.tone() == tone && x > last && x >= NAMES_PX && change.timeNs() <= toNs) {
          lines.moveTo(x, top);
          lines.lineTo(x, bottom);
          last = x;
        }
      }
      if (last > 0) {
        page.setColor(
            switch (tone) {
              case PLAIN -> theme.ink();
              case GOOD -> theme.muted();
              case ALARM -> theme.alarm();
            });
        page.draw(lines);
      }
    }
  }

  /** The text as far as it fits; empty if nothing does. */
  private static String cut(Graphics2D page, String text, double widthPx) {
    if (page.getFontMetrics().stringWidth(text) <= widthPx) {
      return text;
    }
    int end = Math.min(text.length(), (int) (Math.max(0, widthPx) / 3));
    while (end > 0
        && page.getFontMetrics().stringWidth(text.substring(0, end) + "\u2026") > widthPx) {
      end--;
    }
    return end < 2 ? "" : text.substring(0, end) + "\u2026";
  }
}
