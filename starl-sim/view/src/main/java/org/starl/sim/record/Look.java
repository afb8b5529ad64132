package org.starl.sim.record;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;

/**
 * How to paint a scene. {@link Layer}s read it too.
 *
 * @param parts visible parts of the picture
 * @param hidden invisible parts of the app's drawing, as {@link Layer#parts} names them
 * @param selected the selected robot; null if none is
 * @param trailPoints greatest number of points of a trail; the latest ones are painted
 * @param rangeMm range of the radio; 0 if it is unlimited
 * @param pixelMm size of a pixel in mm, for shapes of the same size at every zoom
 */
public record Look(
    Theme theme,
    Set<Part> parts,
    Set<String> hidden,
    @Nullable RobotId selected,
    int trailPoints,
    double rangeMm,
    double pixelMm) {

  /** For pictures in files. */
  public static final Look FILE =
      new Look(
          Theme.LIGHT,
          EnumSet.complementOf(EnumSet.of(Part.MESSAGES, Part.RANGE, Part.LOCATIONS)),
          Set.of(),
          null,
          Integer.MAX_VALUE,
          0,
          1);

  public Look {
    parts = Collections.unmodifiableSet(new TreeSet<>(parts));
    hidden = Collections.unmodifiableSet(new TreeSet<>(hidden));
  }

  public Look in(Theme newTheme) {
    return new Look(newTheme, parts, hidden, selected, trailPoints, rangeMm, pixelMm);
  }

  public Look with(Part part, boolean isOn) {
    Set<Part> changed = new TreeSet<>(parts);
    if (isOn) {
      changed.add(part);
    } else {
      changed.remove(part);
    }
    return new Look(theme, changed, hidden, selected, trailPoints, rangeMm, pixelMm);
  }

  /** Shows or hides one of {@link Layer#parts}. */
  public Look with(String part, boolean isOn) {
    Set<String> changed = new TreeSet<>(hidden);
    if (isOn) {
      changed.remove(part);
    } else {
      changed.add(part);
    }
    return new Look(theme, parts, changed, selected, trailPoints, rangeMm, pixelMm);
  }

  /** With another selected robot; null for none. */
  public Look about(@Nullable RobotId robot) {
    return new Look(theme, parts, hidden, robot, trailPoints, rangeMm, pixelMm);
  }

  /** With at most {@code points} points per trail. */
  public Look withTrails(int points) {
    return new Look(theme, parts, hidden, selected, points, rangeMm, pixelMm);
  }

  /** With a range of the radio; 0 for an unlimited one. */
  public Look withRange(double newRangeMm) {
    return new Look(theme, parts, hidden, selected, trailPoints, newRangeMm, pixelMm);
  }

  Look at(Viewport viewport) {
    return new Look(theme, parts, hidden, selected, trailPoints, rangeMm, 1 / viewport.pxPerMm());
  }

  public boolean shows(Part part) {
    return parts.contains(part);
  }

  /** Whether one of {@link Layer#parts} is visible. */
  public boolean shows(String part) {
    return !hidden.contains(part);
  }

  /** The colour of a robot. */
  public Color robot(Scene scene, RobotId robot) {
    return theme.robot(scene.number(robot));
  }

  /** A solid line, at least 1 pixel wide. */
  public BasicStroke line(double widthMm) {
    return new BasicStroke(atLeast(widthMm, 1), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  }

  /**
   * Round dots, {@code stepMm} from centre to centre; at least 2 pixels wide and 6 pixels apart.
   */
  public BasicStroke dots(double widthMm, double stepMm) {
    float[] dash = {(float) (widthMm / 50), atLeast(stepMm, 6)};
    return new BasicStroke(
        atLeast(widthMm, 2), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 10, dash, 0);
  }

  /** Dashes with gaps of the same length; at least 1 pixel wide and 4 pixels long. */
  public BasicStroke dashes(double widthMm, double lengthMm) {
    float[] dash = {atLeast(lengthMm, 4), atLeast(lengthMm, 4)};
    return new BasicStroke(
        atLeast(widthMm, 1), BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dash, 0);
  }

  private float atLeast(double mm, double px) {
    return (float) Math.max(mm, px * pixelMm);
  }
}
