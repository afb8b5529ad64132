package org.starl.sim.view;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;
import javax.swing.UIManager;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Painter;

/** Icons for buttons, 16 by 16 pixels, in the colour of text. */
enum Glyph implements Icon {
  PLAY,
  PAUSE,
  STEP,
  STEP_BACK,
  EVENT,
  EVENT_BACK,
  FIRST,
  LAST,
  NEXT_MARK,
  PREVIOUS_MARK;

  private static final int SIZE = 16;

  @Override
  public int getIconWidth() {
    return SIZE;
  }

  @Override
  public int getIconHeight() {
    return SIZE;
  }

  @Override
  public void paintIcon(Component on, Graphics graphics, int x, int y) {
    Graphics2D page = (Graphics2D) graphics.create();
    page.translate(x, y);
    Painter.smooth(page);
    page.setColor(
        on.isEnabled() ? on.getForeground() : UIManager.getColor("Label.disabledForeground"));
    page.setStroke(new BasicStroke(1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    switch (this) {
      case PLAY -> page.fill(triangle(4, 2.5, 14, 13.5));
      case PAUSE -> {
        page.fill(new Rectangle2D.Double(3.5, 2.5, 3.2, 11));
        page.fill(new Rectangle2D.Double(9.3, 2.5, 3.2, 11));
      }
      case STEP -> step(page);
      case STEP_BACK -> step(mirrored(page));
      case EVENT -> event(page);
      case EVENT_BACK -> event(mirrored(page));
      case LAST -> last(page);
      case FIRST -> last(mirrored(page));
      case NEXT_MARK -> mark(page);
      case PREVIOUS_MARK -> mark(mirrored(page));
    }
    page.dispose();
  }

  private static Graphics2D mirrored(Graphics2D page) {
    page.translate(SIZE, 0);
    page.scale(-1, 1);
    return page;
  }

  /** Points to the right. */
  private static Path2D triangle(double left, double top, double right, double bottom) {
    return Figures.polygon(left, top, right, (top + bottom) / 2, left, bottom);
  }

  private static void step(Graphics2D page) {
    page.fill(triangle(2, 3.5, 8, 12.5));
    page.fill(triangle(8, 3.5, 14, 12.5));
  }

  private static void event(Graphics2D page) {
    page.fill(new Rectangle2D.Double(3, 3.5, 2, 9));
    page.fill(triangle(7, 3.5, 14, 12.5));
  }

  private static void last(Graphics2D page) {
    page.fill(triangle(2.5, 3.5, 11, 12.5));
    page.fill(new Rectangle2D.Double(11, 3.5, 2.2, 9));
  }

  private static void mark(Graphics2D page) {
    page.draw(new Line2D.Double(4, 2, 4, 14));
    page.fill(triangle(4, 2.5, 13, 9));
  }
}
