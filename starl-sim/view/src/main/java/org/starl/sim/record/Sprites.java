package org.starl.sim.record;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** Prepared small images of bodies, by colour and heading, for pictures of thousands of robots. */
final class Sprites {

  private static final int HEADINGS = 48;

  private final BodyPainter painter = new BodyPainter();
  private final @Nullable BufferedImage[] made = new BufferedImage[Theme.hues() * HEADINGS];
  private Theme theme = Theme.LIGHT;
  private double radiusPx;
  private int sizePx;

  /** Prepares sprites for bodies of this size, in device pixels; discards those of another size. */
  void prepare(Theme newTheme, double newRadiusPx) {
    if (newTheme != theme || newRadiusPx != radiusPx) {
      theme = newTheme;
      radiusPx = newRadiusPx;
      sizePx = 2 * (int) Math.ceil(radiusPx + 1) + 1;
      Arrays.fill(made, null);
    }
  }

  /** From a sprite's corner to its middle. */
  int halfPx() {
    return sizePx / 2;
  }

  BufferedImage of(int number, double headingRad) {
    int heading =
        Math.floorMod(Math.round((float) (headingRad / (2 * Math.PI) * HEADINGS)), HEADINGS);
    int index = number % Theme.hues() * HEADINGS + heading;
    BufferedImage sprite = made[index];
    if (sprite == null) {
      sprite = make(number, heading * 2 * Math.PI / HEADINGS);
      made[index] = sprite;
    }
    return sprite;
  }

  private BufferedImage make(int number, double headingRad) {
    BufferedImage image = new BufferedImage(sizePx, sizePx, BufferedImage.TYPE_INT_ARGB_PRE);
    Graphics2D page = image.createGraphics();
    page.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    page.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    double middle = sizePx / 2.0;
    painter.paint(page, middle, middle, radiusPx, headingRad, theme.robot(number), theme);
    page.dispose();
    return image;
  }
}
