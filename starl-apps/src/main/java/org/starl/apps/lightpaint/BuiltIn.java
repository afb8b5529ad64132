package org.starl.apps.lightpaint;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.lightpaint.logic.Flattened;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;

/** A drawing for those who bring none: a house, its path and the sun. */
final class BuiltIn {

  private static final double WIDTH_MM = 25;
  private static final int SUN_CORNERS = 24;

  private final List<Line> lines = new ArrayList<>();

  private BuiltIn() {}

  static List<Line> house(double flatnessMm) {
    BuiltIn house = new BuiltIn();
    house.line(0x3366cc, 400, 300, 2000, 300, 2000, 1400, 400, 1400, 400, 300);
    house.line(0xcc3322, 250, 1400, 1200, 2150, 2150, 1400);
    house.line(0x8a5a2b, 1350, 300, 1350, 950, 1750, 950, 1750, 300);
    house.line(0x3366cc, 650, 700, 1050, 700, 1050, 1100, 650, 1100, 650, 700);
    house.line(0x2e8b57, 2000, 300, 3400, 300);
    house.sun(new Point(2850, 1900), 300, flatnessMm);
    for (int i = 0; i < 4; i++) {
      house.ray(new Point(2850, 1900), StrictMath.PI * (i + 2) / 4 + StrictMath.PI / 2);
    }
    return house.lines;
  }

  private void line(int rgb, double... xy) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < xy.length; i += 2) {
      points.add(new Point(xy[i], xy[i + 1]));
    }
    lines.add(new Line(new Polyline(points), new Ink(rgb, WIDTH_MM)));
  }

  private void sun(Point middle, double radiusMm, double flatnessMm) {
    List<Point> circle = new ArrayList<>();
    for (int i = 0; i <= SUN_CORNERS; i++) {
      circle.add(middle.plus(direction(2 * StrictMath.PI * i / SUN_CORNERS).times(radiusMm)));
    }
    Polyline flat = new Polyline(Flattened.of(circle, flatnessMm));
    lines.add(new Line(flat, new Ink(0xf5a800, WIDTH_MM)));
  }

  private void ray(Point middle, double angleRad) {
    Point from = middle.plus(direction(angleRad).times(400));
    Point to = middle.plus(direction(angleRad).times(650));
    line(
        0xf5a800,
        StrictMath.rint(from.xMm()),
        StrictMath.rint(from.yMm()),
        StrictMath.rint(to.xMm()),
        StrictMath.rint(to.yMm()));
  }

  private static Point direction(double angleRad) {
    return new Point(StrictMath.cos(angleRad), StrictMath.sin(angleRad));
  }
}
