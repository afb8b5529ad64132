package org.starl.sim.record;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** Cached pictures of bodies by colour and heading, to paint thousands of robots. */
final class Sprites {

  private static final int HEADINGS = 48;

  private final BodyPainter painter = new BodyPainter();
  private final @Nullable BufferedImage[] made = new BufferedImage[Theme.hues() * HEADINGS];
  private Theme theme = Theme.LIGHT;
  private double radiusPx;
  private int sizePx;

  /** Sets theme and size of the bodies, in device pixels; a change clears the cache. */
  void prepare(Theme newTheme, double newRadiusPx) {
    if (!newTheme.equals(theme) || newRadiusPx != radiusPx) {
      theme = newTheme;
      radiusPx = newRadiusPx;
      sizePx = 2 * (int) Math.ceil(radiusPx + 1) + 1;
      Arrays.fill(made, null);
    }
  }

  /** Distance from a sprite's corner to its centre. */
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
    Painter.smooth(page);
    double middle = sizePx / 2.0;
    painter.paint(page, middle, middle, radiusPx, headingRad, theme.robot(number), theme);
    page.dispose();
    return image;
  }
}
