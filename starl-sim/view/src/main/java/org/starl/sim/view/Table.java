package org.starl.sim.view;

import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;

/** Rows of text in columns, without a grid; a title takes all of its row. */
final class Table {

  /**
   * A row.
   *
   * @param isTitle whether it opens a group
   * @param cells as many as there are columns; of a title, one
   * @param more all there is to tell of it, for a tooltip
   */
  record Row(boolean isTitle, List<String> cells, String more) {}

  private static final int SIDE_PX = 12;
  private static final int GAP_PX = 8;
  private static final int LONGEST = 1500;

  private final int[] widths;
  private final Surface surface = new Surface(this::paint, this::tip);
  private final JScrollPane pane = new JScrollPane(surface);
  private final int rowPx;
  private List<Row> rows = List.of();

  /**
   * @param widths of all columns but the last, in pixels
   */
  Table(int... widths) {
    this.widths = widths.clone();
    rowPx = new JLabel("X").getPreferredSize().height + 4;
    pane.setBorder(BorderFactory.createEmptyBorder());
    pane.getVerticalScrollBar().setUnitIncrement(rowPx);
    pane.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
  }

  Component pane() {
    return pane;
  }

  /** Shows these rows; where one has scrolled to stays. */
  void show(List<Row> newRows) {
    if (!newRows.equals(rows)) {
      boolean isAsLong = rows.size() == newRows.size();
      rows = newRows;
      if (!isAsLong) {
        surface.high(rows.size() * rowPx + 2 * GAP_PX);
        surface.revalidate();
      }
      surface.repaint();
    }
  }

  private void paint(Graphics2D page, int widthPx, int heightPx) {
    page.setColor(UIManager.getColor("List.background"));
    page.fillRect(0, 0, widthPx, heightPx);
    Color ink = UIManager.getColor("List.foreground");
    Color faint = UIManager.getColor("Label.disabledForeground");
    Font plain = UIManager.getFont("Label.font");
    int seen = page.getClipBounds().y;
    int first = Math.max(0, (seen - GAP_PX) / rowPx);
    int last = Math.min(rows.size() - 1, (seen + page.getClipBounds().height) / rowPx);
    for (int i = first; i <= last; i++) {
      Row row = rows.get(i);
      page.setFont(row.isTitle() ? plain.deriveFont(Font.BOLD) : plain);
      FontMetrics metrics = page.getFontMetrics();
      int y = GAP_PX + i * rowPx + (rowPx + metrics.getAscent() - metrics.getDescent()) / 2;
      int x = SIDE_PX;
      for (int column = 0; column < row.cells().size(); column++) {
        boolean isLast = column == row.cells().size() - 1;
        int right = isLast ? widthPx - SIDE_PX : x + widths[column];
        page.setColor(row.isTitle() || isLast ? ink : faint);
        page.drawString(clipped(row.cells().get(column), metrics, right - x), x, y);
        x = right + GAP_PX;
      }
    }
  }

  private static String clipped(String text, FontMetrics metrics, int mostPx) {
    // Truncates very long text to the largest visible length.
    String line = text.length() > 400 ? text.substring(0, 400) : text;
    if (metrics.stringWidth(line) <= mostPx) {
      return line;
    }
    int end = line.length();
    while (end > 0 && metrics.stringWidth(line.substring(0, end) + "\u2026") > mostPx) {
      end--;
    }
    return line.substring(0, end) + "\u2026";
  }

  private @Nullable String tip(MouseEvent event) {
    int index = (event.getY() - GAP_PX) / rowPx;
    boolean isRow = event.getY() >= GAP_PX && index < rows.size();
    return isRow && !rows.get(index).more().isEmpty() ? wrapped(rows.get(index).more()) : null;
  }

  /** Text of any length as a tooltip. */
  private static String wrapped(String text) {
    String shown = text.length() > LONGEST ? text.substring(0, LONGEST) + "\u2026" : text;
    String safe = shown.replace("&", "&amp;").replace("<", "&lt;").replace("\n", "<br>");
    return "<html><div style='width:360px'>" + safe + "</div></html>";
  }
}
