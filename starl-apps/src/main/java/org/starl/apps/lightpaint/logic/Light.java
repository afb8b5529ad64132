package org.starl.apps.lightpaint.logic;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.part;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * State of a painter's light.
 *
 * @param stroke the number of the stroke that it paints; negative while it is off
 * @param ink while it is on
 */
public record Light(int stroke, @Nullable Ink ink) {

  /** Its shape. */
  static final Shape<Light> SHAPE =
      Shapes.of(
          Light.class,
          part("stroke", INT, Light::stroke),
          part("ink", Shapes.optional(Ink.SHAPE), light -> Optional.ofNullable(light.ink())),
          (stroke, ink) -> new Light(stroke, ink.orElse(null)));

  public static final Light OFF = new Light(-1, null);

  public static Light of(Stroke stroke) {
    return new Light(stroke.number(), stroke.ink());
  }

  public boolean isOn() {
    return ink != null;
  }

  /** The colour to show: white for black ink, which no light has; 0 while it is off. */
  int rgb() {
    if (ink == null) {
      return 0;
    }
    return ink.rgb() == 0 ? Ink.MAX_RGB : ink.rgb();
  }

  /** {@code off}, or {@code 7 #ff8800 25}: number, colour, width in mm. */
  @Override
  public String toString() {
    return ink == null ? "off" : stroke + " " + ink.colour() + " " + ink.widthMm();
  }
}
