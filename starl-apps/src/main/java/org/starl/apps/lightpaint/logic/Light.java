package org.starl.apps.lightpaint.logic;

import org.jspecify.annotations.Nullable;

/**
 * State of a painter's light.
 *
 * @param stroke the number of the stroke that it paints; negative while it is off
 * @param ink while it is on
 */
public record Light(int stroke, @Nullable Ink ink) {

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

  /**
   * Parses the format of {@link #toString}.
   *
   * @throws IllegalArgumentException on any other text
   */
  public static Light parse(String text) {
    if (text.equals("off")) {
      return OFF;
    }
    String[] parts = text.split(" ", -1);
    if (parts.length != 3 || parts[1].length() != 7) {
      throw new IllegalArgumentException("light '" + text + "': expected off, or 7 #ff8800 25");
    }
    int rgb = Integer.parseInt(parts[1].substring(1), 16);
    return new Light(Integer.parseInt(parts[0]), new Ink(rgb, Double.parseDouble(parts[2])));
  }
}
