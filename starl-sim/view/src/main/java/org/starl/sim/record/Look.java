package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.EnumSet;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * The painting options of a scene: its colours, its shown parts, the selected robot and the size of
 * a pixel.
 */
public final class Look {

  /** The look of pictures in files. */
  public static final Look FILE =
      new Look(
          Theme.LIGHT,
          EnumSet.complementOf(EnumSet.of(Part.MESSAGES, Part.RANGE, Part.LOCATIONS)),
          Set.of(),
          null,
          Integer.MAX_VALUE,
          0,
          1);

  private final Theme theme;
  private final Set<Part> parts;
  private final Set<String> hidden;
  private final @Nullable RobotId selected;
  private final int trailPoints;
  private final double rangeMm;
  private final double pixelMm;

  private Look(
      Theme theme,
      Set<Part> parts,
      Set<String> hidden,
      @Nullable RobotId selected,
      int trailPoints,
      double rangeMm,
      double pixelMm) {
    this.theme = theme;
    this.parts = parts;
    this.hidden = hidden;
    this.selected = selected;
    this.trailPoints = trailPoints;
    this.rangeMm = rangeMm;
    this.pixelMm = pixelMm;
  }

  public Look in(Theme newTheme) {
    return new Look(newTheme, parts, hidden, selected, trailPoints, rangeMm, pixelMm);
  }

  public Look with(Part part, boolean isOn) {
    Set<Part> changed = parts.isEmpty() ? EnumSet.noneOf(Part.class) : EnumSet.copyOf(parts);
    if (isOn) {
      changed.add(part);
    } else {
      changed.remove(part);
    }
    return new Look(theme, changed, hidden, selected, trailPoints, rangeMm, pixelMm);
  }

  /** Switches one of {@link Layer#parts}. */
  public Look with(String part, boolean isOn) {
    Set<String> changed = new TreeSet<>(hidden);
    if (isOn) {
      changed.remove(part);
    } else {
      changed.add(part);
    }
    return new Look(theme, parts, changed, selected, trailPoints, rangeMm, pixelMm);
  }

  /** About one robot, or null for all alike. */
  public Look about(@Nullable RobotId robot) {
    return new Look(theme, parts, hidden, robot, trailPoints, rangeMm, pixelMm);
  }

  /** With so many points of a trail at most, the latest ones. */
  public Look withTrails(int points) {
    return new Look(theme, parts, hidden, selected, points, rangeMm, pixelMm);
  }

  /** With a radio that reaches so far; 0 for one without limit. */
  public Look withRange(double newRangeMm) {
    return new Look(theme, parts, hidden, selected, trailPoints, newRangeMm, pixelMm);
  }

  Look at(Viewport viewport) {
    return new Look(theme, parts, hidden, selected, trailPoints, rangeMm, 1 / viewport.pxPerMm());
  }

  public Theme theme() {
    return theme;
  }

  public boolean shows(Part part) {
    return parts.contains(part);
  }

  /** Whether one of {@link Layer#parts} is to be drawn. */
  public boolean shows(String part) {
    return !hidden.contains(part);
  }

  /** The robot that the picture is about; null if about all alike. */
  public @Nullable RobotId selected() {
    return selected;
  }

  /** Whether the radio has a limit. */
  public boolean isRangeKnown() {
    return rangeMm > 0;
  }

  double rangeMm() {
    return rangeMm;
  }

  int trailPoints() {
    return trailPoints;
  }

  /** So many mm are a pixel: for what is to have the same size however far away one looks. */
  public double pixelMm() {
    return pixelMm;
  }

  /** The colour of a robot that is or was on the floor. */
  public Color robot(Scene scene, RobotId robot) {
    return theme.robot(scene.number(robot));
  }

  /** A line so wide, but never less than a pixel. */
  public BasicStroke line(double widthMm) {
    return new BasicStroke(atLeast(widthMm, 1), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  }

  /** A pattern of round dots with this width and distance of centres; at least 2 and 6 pixels. */
  public BasicStroke dots(double widthMm, double stepMm) {
    float[] dash = {(float) (widthMm / 50), atLeast(stepMm, 6)};
    return new BasicStroke(
        atLeast(widthMm, 2), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 10, dash, 0);
  }

  /** Dashes so wide, so long and so far apart; never less than 1, 4 and 4 pixels. */
  public BasicStroke dashes(double widthMm, double lengthMm) {
    float[] dash = {atLeast(lengthMm, 4), atLeast(lengthMm, 4)};
    return new BasicStroke(
        atLeast(widthMm, 1), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dash, 0);
  }

  private float atLeast(double mm, double px) {
    return (float) Math.max(mm, px * pixelMm);
  }
}
