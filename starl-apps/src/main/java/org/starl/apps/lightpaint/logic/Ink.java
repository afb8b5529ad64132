package org.starl.apps.lightpaint.logic;

import java.util.Locale;

/**
 * Colour and width of a line.
 *
 * @param rgb 24 bits, red first
 * @param widthMm above 0
 */
public record Ink(int rgb, double widthMm) {

  public static final int MAX_RGB = 0xFFFFFF;

  public Ink {
    if (rgb < 0 || rgb > MAX_RGB || !(widthMm > 0) || Double.isInfinite(widthMm)) {
      throw new IllegalArgumentException("ink " + rgb + ", " + widthMm + " mm wide");
    }
  }

  /** {@code #ff8800}. */
  public String colour() {
    return String.format(Locale.ROOT, "#%06x", rgb);
  }
}
