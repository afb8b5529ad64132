package org.starl.sim.fault;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Areas as text: {@code rect(0,0,2m,1m)}, two corners; {@code circle(0,0,2m)}, centre, radius. */
final class AreaText {

  static final String EXPECTED = "expected rect(0,0,2m,1m), two corners, or circle(0,0,2m)";

  private static final Pattern FORM = Pattern.compile("\\s*(rect|circle)\\((.*)\\)\\s*");

  private AreaText() {}

  static Region parse(String text) {
    Matcher form = FORM.matcher(text);
    if (form.matches()) {
      List<String> parts = List.of(form.group(2).split(",", -1));
      try {
        if (form.group(1).equals("rect") && parts.size() == 4) {
          return new Rectangle(mm(parts, 0), mm(parts, 1), mm(parts, 2), mm(parts, 3));
        }
        if (form.group(1).equals("circle") && parts.size() == 3) {
          return new Circle(
              new Point(mm(parts, 0), mm(parts, 1)), Quantities.distanceMm(parts.get(2)));
        }
      } catch (IllegalArgumentException wrongSides) {
        throw new BadInput(BadInput.quote(text) + ": " + wrongSides.getMessage());
      }
    }
    throw new BadInput(BadInput.quote(text) + ": " + EXPECTED);
  }

  /**
   * @throws IllegalArgumentException if the grammar has no word for {@code area}
   */
  static String write(Region area) {
    if (area instanceof Rectangle r) {
      return "rect("
          + text(r.xMinMm())
          + ","
          + text(r.yMinMm())
          + ","
          + text(r.xMaxMm())
          + ","
          + text(r.yMaxMm())
          + ")";
    }
    if (area instanceof Circle c) {
      String radius = Quantities.distanceText(c.radiusMm());
      return "circle(" + text(c.center().xMm()) + "," + text(c.center().yMm()) + "," + radius + ")";
    }
    throw new IllegalArgumentException(area + ": expected a rectangle or a circle");
  }

  // Coordinates are signed distances.
  private static double mm(List<String> parts, int index) {
    String part = parts.get(index).strip();
    return part.startsWith("-")
        ? 0.0 - Quantities.distanceMm(part.substring(1))
        : Quantities.distanceMm(part);
  }

  private static String text(double mm) {
    return mm < 0 ? "-" + Quantities.distanceText(-mm) : Quantities.distanceText(mm);
  }
}
