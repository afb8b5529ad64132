package org.starl.apps.lightpaint.logic;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.part;

import java.util.Locale;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * Colour and width of a line.
 *
 * @param rgb 24 bits, red first
 * @param widthMm above 0
 */
public record Ink(int rgb, double widthMm) {

  public static final int MAX_RGB = 0xFFFFFF;

  /** Its shape. */
  static final Shape<Ink> SHAPE =
      Shapes.of(
          Ink.class, part("rgb", INT, Ink::rgb), part("widthMm", REAL, Ink::widthMm), Ink::new);

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
