package org.starl;

import java.util.Locale;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * The colour of a robot's light.
 *
 * @param rgb from 0, which is off, to 0xFFFFFF, red first
 */
public record LightColour(int rgb) {

  /** Its shape. */
  public static final Shape<LightColour> SHAPE =
      Shapes.of(
          LightColour.class, Shapes.part("rgb", Shapes.INT, LightColour::rgb), LightColour::new);

  /** The light is off. */
  public static final LightColour OFF = new LightColour(0);

  /** {@code off}, or {@code #ff8800}. */
  @Override
  public String toString() {
    return rgb == 0 ? "off" : String.format(Locale.ROOT, "#%06x", rgb);
  }
}
