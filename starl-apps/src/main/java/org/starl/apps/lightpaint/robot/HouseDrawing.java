package org.starl.apps.lightpaint.robot;

import java.util.ArrayList;
import java.util.List;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;

/** The default drawing: a house, its path and the sun, in mm, the lower left corner at 0, 0. */
public final class HouseDrawing {

  private static final double HEIGHT_MM = 2300;
  private static final double WIDTH_OF_LINES_MM = 25;

  private static final int BLUE = 0x3366cc;
  private static final int RED = 0xcc3322;
  private static final int BROWN = 0x8a5a2b;
  private static final int GREEN = 0x2e8b57;
  private static final int YELLOW = 0xf5a800;

  private static final String SUN =
      "3150,400 3140,322 3110,250 3062,188 3000,140 2928,110 2850,100 2772,110 2700,140 2638,188"
          + " 2590,250 2560,322 2550,400 2560,478 2590,550 2638,612 2700,660 2772,690 2850,700"
          + " 2928,690 3000,660 3062,612 3110,550 3140,478 3150,400";

  private HouseDrawing() {}

  /**
   * @param flatnessMm twice the maximum distance of a point from the line that replaces it
   */
  public static List<Line> lines(double flatnessMm) {
    List<Line> lines = new ArrayList<>();
    add(lines, flatnessMm, BLUE, "400,2000 2000,2000 2000,900 400,900 400,2000");
    add(lines, flatnessMm, RED, "250,900 1200,150 2150,900");
    add(lines, flatnessMm, BROWN, "1350,2000 1350,1350 1750,1350 1750,2000");
    add(lines, flatnessMm, BLUE, "650,1600 1050,1600 1050,1200 650,1200 650,1600");
    add(lines, flatnessMm, GREEN, "2000,2000 3400,2000");
    add(lines, flatnessMm, YELLOW, SUN);
    add(lines, flatnessMm, YELLOW, "2450,400 2200,400");
    add(lines, flatnessMm, YELLOW, "2567,683 2390,860");
    add(lines, flatnessMm, YELLOW, "2850,800 2850,1050");
    add(lines, flatnessMm, YELLOW, "3133,683 3310,860");
    return lines;
  }

  /**
   * Adds a line.
   *
   * @param points as in an SVG file: {@code x,y} of each, y downwards
   */
  private static void add(List<Line> lines, double flatnessMm, int rgb, String points) {
    List<Point> all = new ArrayList<>();
    for (String point : points.split(" ", -1)) {
      int comma = point.indexOf(',');
      double xMm = Double.parseDouble(point.substring(0, comma));
      all.add(new Point(xMm, HEIGHT_MM - Double.parseDouble(point.substring(comma + 1))));
    }
    List<Point> simple = Polyline.simplified(all, flatnessMm / 2);
    if (simple.size() > 1) {
      lines.add(new Line(new Polyline(simple), new Ink(rgb, WIDTH_OF_LINES_MM)));
    }
  }
}
