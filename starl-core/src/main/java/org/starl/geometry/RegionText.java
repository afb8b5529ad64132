package org.starl.geometry;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Regions as text in the trace: {@code everywhere}, {@code circle(0.0 0.0 500.0)}, {@code
 * union(rectangle(0.0 0.0 1.0 1.0) nowhere)}; numbers in mm, exact to the last bit.
 */
public final class RegionText {

  private static final int MOST_CHARACTERS = 100;
  private static final String CIRCLE = "circle";
  private static final String RECTANGLE = "rectangle";
  private static final String POLYGON = "polygon";
  private static final String UNION = "union";
  private static final String EVERYWHERE = "everywhere";
  private static final String NOWHERE = "nowhere";

  private final String text;
  private int position;

  private RegionText(String text) {
    this.text = text;
  }

  /** The region as text; {@link #parse} reads it back. */
  public static String format(Region region) {
    return switch (region) {
      case Nowhere nowhere -> NOWHERE;
      case Everywhere everywhere -> EVERYWHERE;
      case Circle circle -> call(CIRCLE, List.of(format(circle.center()), circle.radiusMm()));
      case Rectangle r -> call(RECTANGLE, List.of(r.xMinMm(), r.yMinMm(), r.xMaxMm(), r.yMaxMm()));
      case Polygon polygon ->
          call(
              POLYGON,
              polygon.vertices().stream().map(RegionText::format).collect(Collectors.toList()));
      case Union union ->
          call(UNION, union.parts().stream().map(RegionText::format).collect(Collectors.toList()));
    };
  }

  /**
   * The region for people: as {@link #format}, or, if that has more than 100 characters, its kind and
   * size, and its ranges of x and y.
   */
  static String brief(Region region) {
    String whole = format(region);
    if (whole.length() <= MOST_CHARACTERS) {
      return whole;
    }
    List<Point> corners = new ArrayList<>();
    addCorners(region, corners);
    String kind =
        region instanceof Union union
            ? "union of " + union.parts().size() + " regions"
            : "polygon of " + corners.size() + " corners";
    String x = range(corners.stream().mapToDouble(Point::xMm).summaryStatistics());
    String y = range(corners.stream().mapToDouble(Point::yMm).summaryStatistics());
    return kind + " within " + x + ", " + y + " mm";
  }

  private static String range(DoubleSummaryStatistics of) {
    return StrictMath.round(of.getMin()) + ".." + StrictMath.round(of.getMax());
  }

  private static void addCorners(Region region, List<Point> corners) {
    switch (region) {
      case Circle c -> {
        Point diagonal = new Point(c.radiusMm(), c.radiusMm());
        corners.addAll(List.of(c.center().minus(diagonal), c.center().plus(diagonal)));
      }
      case Rectangle r ->
          corners.addAll(
              List.of(new Point(r.xMinMm(), r.yMinMm()), new Point(r.xMaxMm(), r.yMaxMm())));
      case Polygon polygon -> corners.addAll(polygon.vertices());
      case Union union -> union.parts().forEach(part -> addCorners(part, corners));
      case Nowhere nowhere -> {
        // It has no corners.
      }
      case Everywhere everywhere -> {
        // It has no corners.
      }
    }
  }

  /**
   * Parses the text of {@link #format}.
   *
   * @throws IllegalArgumentException if {@code text} has another form
   */
  public static Region parse(String text) {
    RegionText parser = new RegionText(text);
    Region region = parser.region();
    parser.expect(parser.position == text.length());
    return region;
  }

  private static String call(String name, List<?> arguments) {
    StringBuilder text = new StringBuilder(name).append('(');
    for (int i = 0; i < arguments.size(); i++) {
      text.append(i == 0 ? "" : " ").append(arguments.get(i));
    }
    return text.append(')').toString();
  }

  private static String format(Point point) {
    return point.xMm() + " " + point.yMm();
  }

  private Region region() {
    String name = word();
    switch (name) {
      case NOWHERE:
        return new Nowhere();
      case EVERYWHERE:
        return new Everywhere();
      case UNION:
        List<Region> parts = new ArrayList<>();
        do {
          skip();
          parts.add(region());
        } while (text.startsWith(" ", position));
        skip();
        return new Union(parts);
      default:
        return plain(name, numbers());
    }
  }

  private Region plain(String name, List<Double> n) {
    boolean known =
        switch (name) {
          case CIRCLE -> n.size() == 3;
          case RECTANGLE -> n.size() == 4;
          case POLYGON -> n.size() % 2 == 0;
          default -> false;
        };
    expect(known);
    if (name.equals(CIRCLE)) {
      return new Circle(new Point(n.get(0), n.get(1)), n.get(2));
    }
    if (name.equals(RECTANGLE)) {
      return new Rectangle(n.get(0), n.get(1), n.get(2), n.get(3));
    }
    List<Point> vertices = new ArrayList<>();
    for (int i = 0; i < n.size(); i += 2) {
      vertices.add(new Point(n.get(i), n.get(i + 1)));
    }
    return new Polygon(vertices);
  }

  private List<Double> numbers() {
    List<Double> numbers = new ArrayList<>();
    do {
      skip();
      numbers.add(Double.valueOf(word()));
    } while (text.startsWith(" ", position));
    skip();
    return numbers;
  }

  private String word() {
    int start = position;
    while (position < text.length() && "() ".indexOf(text.charAt(position)) < 0) {
      position++;
    }
    return text.substring(start, position);
  }

  /** Skips one bracket or blank. */
  private void skip() {
    expect(position < text.length());
    position++;
  }

  private void expect(boolean fits) {
    if (!fits) {
      throw new IllegalArgumentException("'" + text + "' at " + position + ": expected a region");
    }
  }
}
