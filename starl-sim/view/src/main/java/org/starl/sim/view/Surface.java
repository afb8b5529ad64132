package org.starl.sim.view;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.util.function.Function;
import javax.swing.JComponent;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.Painter;

/** A component that a function paints. */
// Never serialized: a window is not kept in files.
@SuppressWarnings("serial")
final class Surface extends JComponent {

  /** Paints a component of the given size. */
  interface Painting {
    void paint(Graphics2D page, int widthPx, int heightPx);
  }

  private final Painting painting;
  private final Function<MouseEvent, @Nullable String> tip;

  /**
   * @param tip gives the tooltip at the mouse pointer; null for none
   */
  Surface(Painting painting, Function<MouseEvent, @Nullable String> tip) {
    this.painting = painting;
    this.tip = tip;
    setOpaque(true);
    setToolTipText("");
  }

  /** Sets the height, and returns this component; the width is free. */
  Surface high(int heightPx) {
    setPreferredSize(new Dimension(200, heightPx));
    setMinimumSize(new Dimension(50, heightPx));
    return this;
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D page = (Graphics2D) graphics.create();
    Painter.smooth(page);
    painting.paint(page, getWidth(), getHeight());
    page.dispose();
  }

  @Override
  public @Nullable String getToolTipText(MouseEvent event) {
    return tip.apply(event);
  }
}
