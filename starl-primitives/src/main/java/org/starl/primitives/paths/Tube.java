package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * A reach tube: all places within {@code radiusMm} of a line, part by part; where the body of a robot
 * may be that follows the line. One point alone is a disc, where a robot stands.
 *
 * @param points 1 to {@link #MAX_POINTS}, in whole millimetres within {@link PlanTask#MAX_MM}
 * @param radiusMm above 0
 */
public record Tube(List<Point> points, int radiusMm) {

  /** So that what a robot holds and what it asks for fit one datagram. */
  public static final int MAX_POINTS = 32;

  /** Nearer than this counts as touching: far above any rounding of a distance. */
  private static final double TOUCH_MM = 1;

  public Tube {
    points = List.copyOf(points);
    boolean valid = !points.isEmpty() && points.size() <= MAX_POINTS && radiusMm > 0;
    for (Point point : points) {
      valid &= isWhole(point.xMm()) && isWhole(point.yMm());
    }
    if (!valid || radiusMm > PlanTask.MAX_MM) {
      throw new IllegalArgumentException(
          "tube of "
              + points.size()
              + " points, radius "
              + radiusMm
              + " mm: expected 1 to "
              + MAX_POINTS
              + " in whole mm, radius above 0");
    }
  }

  private static boolean isWhole(double mm) {
    return Math.abs(mm) <= PlanTask.MAX_MM && mm == StrictMath.rint(mm);
  }

  static Tube disc(Point center, int radiusMm) {
    return new Tube(List.of(rounded(center)), radiusMm);
  }

  static Point rounded(Point point) {
    return new Point(FreeSpace.x(point), FreeSpace.y(point));
  }

  /** How many parts it has: legs, or the one disc. */
  public int parts() {
    return Math.max(1, points.size() - 1);
  }

  /** Part number {@code i}, from 0. */
  public Capsule part(int i) {
    int to = Math.min(i + 1, points.size() - 1);
    return new Capsule(new Segment(points.get(i), points.get(to)), radiusMm);
  }

  public Point end() {
    return points.get(points.size() - 1);
  }

  /** The tube without its first {@code passed} parts; where all are passed, the disc at its end. */
  public Tube from(int passed) {
    return new Tube(points.subList(Math.min(passed, points.size() - 1), points.size()), radiusMm);
  }

  /** Whether the two have a place in common, or all but. */
  public boolean meets(Tube other) {
    for (int i = 0; i < parts(); i++) {
      for (int j = 0; j < other.parts(); j++) {
        if (part(i).distanceMm(other.part(j)) < TOUCH_MM) {
          return true;
        }
      }
    }
    return false;
  }

  /** Whether a disc lies in one of its parts. */
  public boolean containsDisc(Point center, double discRadiusMm) {
    for (int i = 0; i < parts(); i++) {
      if (part(i).containsDisc(center, discRadiusMm)) {
        return true;
      }
    }
    return false;
  }

  static boolean meet(List<Tube> some, List<Tube> others) {
    for (Tube tube : some) {
      for (Tube other : others) {
        if (tube.meets(other)) {
          return true;
        }
      }
    }
    return false;
  }

  /** {@code 350@500,1500>900,1500}: radius, then the points. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder().append(radiusMm);
    char separator = '@';
    for (Point point : points) {
      text.append(separator).append((int) point.xMm()).append(',').append((int) point.yMm());
      separator = '>';
    }
    return text.toString();
  }

  /** Several, with {@code ;} between them; the empty text for none. */
  static String text(List<Tube> tubes) {
    List<String> texts = new ArrayList<>();
    for (Tube tube : tubes) {
      texts.add(tube.toString());
    }
    return String.join(";", texts);
  }

  /**
   * Reads the value of the variable {@code held} in a trace.
   *
   * @throws IllegalArgumentException if {@code text} is nothing of the kind
   */
  public static List<Tube> parse(String text) {
    List<Tube> tubes = new ArrayList<>();
    for (String tube : text.isEmpty() ? new String[0] : text.split(";", -1)) {
      int at = tube.indexOf('@');
      if (at < 0) {
        throw new IllegalArgumentException("tube '" + tube + "': expected radius@x,y>x,y");
      }
      List<Point> points = new ArrayList<>();
      for (String point : tube.substring(at + 1).split(">", -1)) {
        int comma = point.indexOf(',');
        if (comma < 0) {
          throw new IllegalArgumentException("point '" + point + "' of a tube: expected x,y");
        }
        points.add(
            new Point(
                Integer.parseInt(point.substring(0, comma)),
                Integer.parseInt(point.substring(comma + 1))));
      }
      tubes.add(new Tube(points, Integer.parseInt(tube.substring(0, at))));
    }
    return tubes;
  }
}
