package org.starl.apps.lightpaint;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
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
 * the ends of line 7, five units wide. Positions are in mm; the angle column is the colour, 24 bits,
 * red first.
 */
final class WptDrawing {

  private static final Pattern NAME = Pattern.compile("([0-9]{1,9})-([AB])_([0-9]{1,4})");
  private static final String EXPECTED =
      "WAY,x,y,colour,i-A_w and another line with i-B_w: line i of a drawing, w units wide";

  private final String file;
  private final String text;

  private WptDrawing(String file, String text) {
    this.file = file;
    this.text = text;
  }

  /**
   * The lines of a file, in the order of their A ends.
   *
   * @param mmPerUnit scale of the widths
   */
  static List<Line> read(String file, String text, double mmPerUnit) {
    return new WptDrawing(file, text).lines(mmPerUnit);
  }

  private List<Line> lines(double mmPerUnit) {
    Map<String, Waypoint> ends = new LinkedHashMap<>();
    for (Waypoint end : WaypointFiles.parse(file, text).waypoints()) {
      check(NAME.matcher(end.name()).matches(), end, "is no end of a line");
      check(ends.put(end.name(), end) == null, end, "is there twice");
    }
    List<Line> lines = new ArrayList<>();
    for (Waypoint end : ends.values()) {
      Matcher name = NAME.matcher(end.name());
      check(name.matches(), end, "is no end of a line");
      boolean isA = name.group(2).equals("A");
      String otherName = name.group(1) + (isA ? "-B_" : "-A_") + name.group(3);
      Waypoint other = ends.get(otherName);
      if (other == null) {
        throw bad(end, "has no " + otherName);
      }
      Point from = Polyline.rounded(new Point(end.xMm(), end.yMm()));
      Point to = Polyline.rounded(new Point(other.xMm(), other.yMm()));
      if (isA) {
        Ink ink = ink(end, other, Integer.parseInt(name.group(3)) * mmPerUnit);
        if (!from.equals(to)) {
          lines.add(new Line(new Polyline(List.of(from, to)), ink));
        }
      }
    }
    return lines;
  }

  private Ink ink(Waypoint a, Waypoint b, double widthMm) {
    double rgb = a.angle();
    boolean isColour = rgb == StrictMath.rint(rgb) && rgb >= 0 && rgb <= Ink.MAX_RGB;
    check(isColour, a, "has a third column that is no colour, 0 to 16777215");
    check(b.angle() == rgb, b, "has another colour than " + a.name());
    check(widthMm > 0, a, "has no width");
    return new Ink((int) rgb, Math.max(1, StrictMath.rint(widthMm)));
  }

  private void check(boolean isGood, Waypoint end, String problem) {
    if (!isGood) {
      throw bad(end, problem);
    }
  }

  private BadInput bad(Waypoint end, String problem) {
    return new BadInput(
        "%s:%d: '%s' %s: expected %s"
            .formatted(file, lineOf(end.name()), end.name(), problem, EXPECTED));
  }

  /** The number of the last line that has this name. */
  private int lineOf(String name) {
    List<String> all = text.lines().toList();
    for (int i = all.size() - 1; i > 0; i--) {
      String[] fields = all.get(i).split(",", -1);
      if (fields.length > 4 && fields[4].strip().equals(name)) {
        return i + 1;
      }
    }
    return 1;
  }
}
