package org.starl.apps.lightpaint;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * Reads drawings of the original StarL: waypoint files in which {@code 7-A_5} and {@code 7-B_5} are
 * the ends of line 7, five units wide. Positions are in mm; the angle column is the colour, 24
 * bits, red first.
 */
final class WptDrawing {

  private static final Pattern NAME = Pattern.compile("[0-9]{1,9}-[AB]_[0-9]{1,4}");
  private static final String EXPECTED =
      "WAY,x,y,colour,i-A_w and another line with i-B_w: line i of a drawing, w units wide";

  private final String file;

  private WptDrawing(String file) {
    this.file = file;
  }

  /**
   * The lines of a file, in the order of their A ends.
   *
   * @param mmPerUnit scale of the widths
   */
  static List<Line> read(String file, String text, double mmPerUnit) {
    return new WptDrawing(file).lines(WaypointFiles.parse(file, text).waypoints(), mmPerUnit);
  }

  private List<Line> lines(List<Waypoint> waypoints, double mmPerUnit) {
    Map<String, Waypoint> ends = new LinkedHashMap<>();
    for (Waypoint end : waypoints) {
      check(NAME.matcher(end.name()).matches(), end, "does not name the end of a line");
      check(ends.put(end.name(), end) == null, end, "is there twice");
    }
    List<Line> lines = new ArrayList<>();
    for (Waypoint a : ends.values()) {
      boolean isA = a.name().contains("A");
      String other = isA ? a.name().replace('A', 'B') : a.name().replace('B', 'A');
      check(ends.containsKey(other), a, "has no " + other);
      Waypoint b = ends.getOrDefault(other, a);
      if (isA) {
        Ink ink = ink(a, b, mmPerUnit);
        Point from = Polyline.rounded(new Point(a.xMm(), a.yMm()));
        Point to = Polyline.rounded(new Point(b.xMm(), b.yMm()));
        if (!from.equals(to)) {
          lines.add(new Line(new Polyline(List.of(from, to)), ink));
        }
      }
    }
    return lines;
  }

  private Ink ink(Waypoint a, Waypoint b, double mmPerUnit) {
    double rgb = a.angle();
    boolean isColour = rgb == StrictMath.rint(rgb) && rgb >= 0 && rgb <= Ink.MAX_RGB;
    check(isColour, a, "has a third column that is not a colour from 0 to 16777215");
    check(b.angle() == rgb, b, "has another colour than " + a.name());
    int width = Integer.parseInt(a.name().substring(a.name().indexOf('_') + 1));
    check(width > 0, a, "has no width");
    return new Ink((int) rgb, Math.max(1, StrictMath.rint(width * mmPerUnit)));
  }

  private void check(boolean isGood, Waypoint end, String problem) {
    if (!isGood) {
      throw new BadInput(
          "%s:%d: '%s' %s: expected %s".formatted(file, end.line(), end.name(), problem, EXPECTED));
    }
  }
}
