package org.starl.sim.record;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;

/**
 * The colours of a picture. Layers use them, so that their drawings are visible on light and on
 * dark paper.
 */
public final class Theme {

  // Twelve hues that can be distinguished on paper (after Tol's and Okabe and Ito's palettes).
  private static final int[] ON_LIGHT = {
    0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0xE69F00, 0x56B4E9,
    0x882255, 0x117733, 0x999933, 0x332288, 0xAA4499, 0x44AA99
  };

  /** The same hues, lighter where they were too dark for dark paper. */
  private static final int[] ON_DARK = {
    0x4BA3E3, 0xF0803C, 0x2DC997, 0xE79AC4, 0xF5BA3D, 0x86CDF5,
    0xD0679F, 0x5DBB63, 0xC9C95A, 0x9A8CF0, 0xD77FD0, 0x6FD3C6
  };

  public static final Theme LIGHT = light();
  public static final Theme DARK = dark();

  private final boolean isDark;
  private final List<Color> robots;
  private final Color paper;
  private final Color ink;
  private final Color muted;
  private final Color floor;
  private final Color shade;
  private final Color border;
  private final Color wall;
  private final Color hidden;
  private final Color alarm;
  private final Color gold;

  private Theme(boolean isDark, int... colours) {
    this.isDark = isDark;
    robots = Arrays.stream(isDark ? ON_DARK : ON_LIGHT).mapToObj(Color::new).toList();
    paper = new Color(colours[0]);
    ink = new Color(colours[1]);
    muted = new Color(colours[2]);
    floor = new Color(colours[3]);
    shade = new Color(colours[4]);
    border = new Color(colours[5]);
    wall = new Color(colours[6]);
    hidden = new Color(colours[7]);
    alarm = new Color(colours[8]);
    gold = new Color(colours[9]);
  }

  private static Theme light() {
    return new Theme(
        false, 0xFAFAF7, 0x222222, 0x77746B, 0xF0F0EA, 0xDBD9D0, 0x99958C, 0x555555, 0xB04020,
        0xC02020, 0xE8B010);
  }

  private static Theme dark() {
    return new Theme(
        true, 0x1E2124, 0xE6E6E3, 0x9C9A93, 0x282C30, 0x353A40, 0x5C6269, 0xB4B9BE, 0xE0704A,
        0xFF6B60, 0xF2C230);
  }

  public boolean isDark() {
    return isDark;
  }

  /** Of a robot by its {@link Scene#number}. */
  public Color robot(int number) {
    return robots.get(number % robots.size());
  }

  static int hues() {
    return ON_LIGHT.length;
  }

  /** Behind everything. */
  public Color paper() {
    return paper;
  }

  /** Text and lines. */
  public Color ink() {
    return ink;
  }

  /** Secondary text and lines. */
  public Color muted() {
    return muted;
  }

  /** Neutral ground; slightly different from the paper. */
  public Color floor() {
    return floor;
  }

  /** Ground that stands out from {@link #floor}. */
  public Color shade() {
    return shade;
  }

  /** Around areas. */
  public Color border() {
    return border;
  }

  /** Obstacles that all robots know of. */
  public Color wall() {
    return wall;
  }

  /** Obstacles that no robot knows of. */
  public Color hidden() {
    return hidden;
  }

  /** Errors and search targets. */
  public Color alarm() {
    return alarm;
  }

  /** Crowns and marks. */
  public Color gold() {
    return gold;
  }

  /** The outline colour of a shape filled with {@code colour}. */
  public Color edge(Color colour) {
    return isDark ? mixed(colour, Color.WHITE, 0.25) : colour.darker();
  }

  /** The colour itself if it contrasts with the paper; otherwise nearer to the ink. */
  public Color visible(Color colour) {
    return Math.abs(luma(colour) - luma(paper)) < LEAST_CONTRAST
        ? mixed(colour, ink, 0.45)
        : colour;
  }

  private static final double LEAST_CONTRAST = 48;

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
   * The colour with transparency.
   *
   * @param alpha from 0, invisible, to 255, opaque
   */
  public static Color faded(Color colour, int alpha) {
    return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha);
  }
}
