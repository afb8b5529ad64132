package org.starl.sim.view.page;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * One drawing operation of a page. Coordinates are tenths of a pixel.
 *
 * @param kind what {@code numbers} mean, see the constants
 * @param rgba colour, as {@link java.awt.Color#getRGB}
 * @param pen {@link Pen#NONE} for a filled area
 * @param text of a text; a data URL for an image; else empty
 * @param numbers sizes first, then coordinates, x and y alternating
 */
@SuppressWarnings("ArrayRecordComponent") // equals and hashCode compare the numbers themselves
record DrawnItem(int kind, int rgba, Pen pen, String text, int[] numbers) {

  /**
   * A stroke or a font.
   *
   * @param width of a stroke
   * @param text in the syntax of {@link ShapeRecorder}
   */
  record Pen(int width, String text) {

    static final Pen NONE = new Pen(0, "");
  }

  /** Points of an open line. */
  static final int LINE = 0;

  /** Points of a closed line. */
  static final int POLYGON = 1;

  /** Half width, half height, centre. */
  static final int ELLIPSE = 2;

  /** Number of the text, width; left end of the baseline. */
  static final int TEXT = 3;

  /** Number of the image, width, height; upper left corner. */
  static final int IMAGE = 4;

  /** Segments, each {@link java.awt.geom.PathIterator}'s number and its points. */
  static final int PATH = 5;

  boolean isFilled() {
    return pen.equals(Pen.NONE);
  }

  /** Whether both are the same in all but the colour. */
  boolean isSameShape(DrawnItem other) {
    return kind == other.kind
        && pen.equals(other.pen)
        && text.equals(other.text)
        && Arrays.equals(numbers, other.numbers);
  }

  @Override
  public boolean equals(@Nullable Object object) {
    return object instanceof DrawnItem other && rgba == other.rgba && isSameShape(other);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(numbers) + rgba;
  }
}
