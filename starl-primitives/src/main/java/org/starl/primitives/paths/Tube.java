package org.starl.primitives.paths;

import static org.starl.shape.Shapes.INT;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/**
 * A reach tube: all points within {@code radiusMm} of a path. It contains the body of a robot that
 * follows the path. It has one part for each leg; a single point gives a disc, for a standing
 * robot.
 *
 * @param points 1 to {@link #MAX_POINTS}, in whole millimetres within {@link PlanTask#MAX_MM}
 * @param radiusMm above 0
 */
public record Tube(List<Point> points, int radiusMm) {

  /** With this limit, all tubes of a robot fit one datagram. */
  public static final int MAX_POINTS = 32;

  /** A point in whole millimetres. */
  private static final Shape<Point> POINT =
      Shapes.of(
          Point.class,
          Shapes.part("xMm", INT, point -> (int) point.xMm()),
          Shapes.part("yMm", INT, point -> (int) point.yMm()),
          (xMm, yMm) -> new Point(xMm, yMm));

  /** Its shape, in messages, on stable storage and in traces. */
  public static final Shape<Tube> SHAPE =
      Shapes.of(
          Tube.class,
          Shapes.part("radiusMm", INT, Tube::radiusMm),
          Shapes.part("points", Shapes.list(POINT, MAX_POINTS), Tube::points),
          (radiusMm, points) -> new Tube(points, radiusMm));

  /** Tubes closer than this touch; far above the rounding error of a distance. */
  private static final double TOUCH_MM = 1;

  public Tube {
    points = List.copyOf(points);
    boolean valid = !points.isEmpty() && points.size() <= MAX_POINTS && radiusMm > 0;
    for (Point point : points) {
      valid &= isWhole(point.xMm()) && isWhole(point.yMm());
    }
    if (!valid || radiusMm > PlanTask.MAX_MM) {
      throw new IllegalArgumentException(
          String.format(
              "tube of %s points, radius %s mm: expected 1 to %s in whole mm, radius above 0",
              points.size(), radiusMm, MAX_POINTS));
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

  /** The number of parts: the legs, or one disc. */
  public int parts() {
    return Math.max(1, points.size() - 1);
  }

  /** Part number {@code i}, from 0. */
  public Capsule part(int i) {
    int to = Math.min(i + 1, points.size() - 1);
    return new Capsule(new Segment(points.get(i), points.get(to)), radiusMm);
  }

  /** All parts, in order. */
  List<Capsule> capsules() {
    return IntStream.range(0, parts()).mapToObj(this::part).collect(Collectors.toList());
  }

  public Point end() {
    return points.get(points.size() - 1);
  }

  /** The tube without its first {@code passed} parts; the disc at its end if no part is left. */
  public Tube from(int passed) {
    return new Tube(points.subList(Math.min(passed, points.size() - 1), points.size()), radiusMm);
  }

  /** Whether the two overlap or touch. */
  public boolean meets(Tube other) {
    if (isFarFrom(other)) {
      return false;
    }
    List<Capsule> others = other.capsules();
    for (Capsule part : capsules()) {
      for (Capsule otherPart : others) {
        if (part.distanceMm(otherPart) < TOUCH_MM) {
          return true;
        }
      }
    }
    return false;
  }

  /** Whether the bounding boxes are clearly apart: a quick check, as most tubes are far apart. */
  private boolean isFarFrom(Tube other) {
    return endsBefore(other, Point::xMm)
        || other.endsBefore(this, Point::xMm)
        || endsBefore(other, Point::yMm)
        || other.endsBefore(this, Point::yMm);
  }

  private boolean endsBefore(Tube other, ToDoubleFunction<Point> coordinate) {
    double last = -Double.MAX_VALUE;
    for (Point point : points) {
      last = Math.max(last, coordinate.applyAsDouble(point));
    }
    double next = Double.MAX_VALUE;
    for (Point point : other.points) {
      next = Math.min(next, coordinate.applyAsDouble(point));
    }
    return last + radiusMm + other.radiusMm + 2 * TOUCH_MM < next;
  }

  /** Whether a disc lies in one of its parts. */
  public boolean containsDisc(Point center, double discRadiusMm) {
    return capsules().stream().anyMatch(part -> part.containsDisc(center, discRadiusMm));
  }

  static boolean meet(List<Tube> some, List<Tube> others) {
    return some.stream().anyMatch(tube -> others.stream().anyMatch(tube::meets));
  }

  /** The radius and the points, as in {@code 350@500,1500>900,1500}. */
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

  /** The tubes, joined by {@code ;}. */
  static String text(List<Tube> tubes) {
    return tubes.stream().map(Tube::toString).collect(Collectors.joining(";"));
  }
}
