package org.starl.sim.record;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;

/**
 * The colours of a picture. A layer takes its colours from here, so that they are visible in the
 * light and in the dark theme.
 *
 * @param robots colours of robots, distinguishable on {@code paper}
 * @param paper background
 * @param ink text and lines
 * @param muted less important text and lines
 * @param floor ground, slightly different from {@code paper}
 * @param shade ground that contrasts with {@code floor}
 * @param border outline of areas
 * @param wall obstacles that all robots know
 * @param hidden obstacles on no robot's map at the start
 * @param alarm errors and violations
 * @param gold crowns and marks
 */
public record Theme(
    boolean isDark,
    List<Color> robots,
    Color paper,
    Color ink,
    Color muted,
    Color floor,
    Color shade,
    Color border,
    Color wall,
    Color hidden,
    Color alarm,
    Color gold) {

  // Twelve hues that are easy to tell apart (after Tol's and Okabe and Ito's palettes).
  private static final int[] ON_LIGHT = {
    0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9,
    0x882255, 0x117733, 0x999933, 0x332288, 0xAA4499, 0x44AA99
  };

  /** The same hues, lighter where needed on a dark background. */
  private static final int[] ON_DARK = {
    0x4BA3E3, 0xF0803C, 0x2DC997, 0xE79AC4, 0xF5BA3D, 0x86CDF5,
    0xD0679F, 0x5DBB63, 0xC9C95A, 0x9A8CF0, 0xD77FD0, 0x6FD3C6
  };

  private static final double LEAST_CONTRAST = 48;

  public static final Theme LIGHT =
      new Theme(
          false, 0xFAFAF7, 0x222222, 0x77746B, 0xF0F0EA, 0xDBD9D0, 0x99958C, 0x555555, 0xB04020,
          0xC02020, 0xE8B010);
  public static final Theme DARK =
      new Theme(
          true, 0x1E2124, 0xE6E6E3, 0x9C9A93, 0x282C30, 0x353A40, 0x5C6269, 0xB4B9BE, 0xE0704A,
          0xFF6B60, 0xF2C230);

  private Theme(boolean isDark, int... colours) {
    this(
        isDark,
        Arrays.stream(isDark ? ON_DARK : ON_LIGHT).mapToObj(Color::new).toList(),
        new Color(colours[0]),
        new Color(colours[1]),
        new Color(colours[2]),
        new Color(colours[3]),
        new Color(colours[4]),
        new Color(colours[5]),
        new Color(colours[6]),
        new Color(colours[7]),
        new Color(colours[8]),
        new Color(colours[9]));
  }

  /** The colour of a robot, by its {@link Scene#number}. */
  public Color robot(int number) {
    return robots.get(number % robots.size());
  }

  /** Number of robots' colours. */
  static int hues() {
    return ON_LIGHT.length;
  }

  /** The outline of an area filled with {@code colour}. */
  public Color edge(Color colour) {
    return isDark ? mixed(colour, Color.WHITE, 0.25) : colour.darker();
  }

  /** {@code colour} if it contrasts with the paper; else a mix of it with the ink. */
  public Color visible(Color colour) {
    return Math.abs(luma(colour) - luma(paper)) < LEAST_CONTRAST
        ? mixed(colour, ink, 0.45)
        : colour;
  }

  /** Black or white, whichever is readable on {@code ground}. */
  public static Color textOn(Color ground) {
    return luma(ground) > 140 ? Color.BLACK : Color.WHITE;
  }

  private static double luma(Color colour) {
    return 0.299 * colour.getRed() + 0.587 * colour.getGreen() + 0.114 * colour.getBlue();
  }

  private static Color mixed(Color a, Color b, double share) {
    return new Color(
        (int) (a.getRed() + share * (b.getRed() - a.getRed())),
        (int) (a.getGreen() + share * (b.getGreen() - a.getGreen())),
        (int) (a.getBlue() + share * (b.getBlue() - a.getBlue())));
  }

  /**
   * The same colour, transparent.
   *
   * @param alpha opacity from 0 to 255
   */
  public static Color faded(Color colour, int alpha) {
    return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha);
  }
}
