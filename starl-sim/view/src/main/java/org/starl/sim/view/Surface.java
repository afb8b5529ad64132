package org.starl.sim.view;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseEvent;
import java.util.function.Function;
import javax.swing.JComponent;
import org.jspecify.annotations.Nullable;

/** A component with an external painter. */
// Never serialized: a window is not kept in files.
@SuppressWarnings("serial")
final class Surface extends JComponent {

  /** Paints a component of that size. */
  interface Painting {
    void paint(Graphics2D page, int widthPx, int heightPx);
  }

  private final Painting painting;
  private final Function<MouseEvent, @Nullable String> tip;

  /**
   * @param tip what to tell about the place where the mouse is; null for nothing
   */
  Surface(Painting painting, Function<MouseEvent, @Nullable String> tip) {
    this.painting = painting;
    this.tip = tip;
    setOpaque(true);
    setToolTipText("");
  }

  /** The same, wide as it may be. */
  Surface high(int heightPx) {
    setPreferredSize(new Dimension(200, heightPx));
    setMinimumSize(new Dimension(50, heightPx));
    return this;
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D page = (Graphics2D) graphics.create();
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    page.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    painting.paint(page, getWidth(), getHeight());
    page.dispose();
  }

  @Override
  public @Nullable String getToolTipText(MouseEvent event) {
    return tip.apply(event);
  }
}
