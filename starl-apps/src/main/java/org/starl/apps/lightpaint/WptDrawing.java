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
 * Reads the original StarL's drawings: waypoint files in which {@code 7-A_5} and {@code 7-B_5} are
 * the ends of line 7, five units wide. Places are in mm; the angle column is the colour, 24 bits red
 * first.
 */
final class WptDrawing {

  private static final Pattern NAME = Pattern.compile("([0-9]{1,9})-([AB])_([0-9]{1,4})");
  private static final String EXPECTED =
      "WAY,x,y,colour,i-A_w and another line with i-B_w: line i of a drawing, w units wide";

  private final String file;
  private final String text;
  private final double mmPerUnit;

  private WptDrawing(String file, String text, double mmPerUnit) {
    this.file = file;
    this.text = text;
    this.mmPerUnit = mmPerUnit;
  }

  /**
   * The lines of a file, in the order of their first ends.
   *
   * @param mmPerUnit of the widths
   */
  static List<Line> read(String file, String text, double mmPerUnit) {
    return new WptDrawing(file, text, mmPerUnit).lines();
  }

  private List<Line> lines() {
    Map<String, Waypoint> ends = new LinkedHashMap<>();
    for (Waypoint end : WaypointFiles.parse(file, text).waypoints()) {
      if (!NAME.matcher(end.name()).matches()) {
        throw bad(end, "is no end of a line");
      }
      if (ends.put(end.name(), end) != null) {
        throw bad(end, "is there twice");
      }
    }
    List<Line> lines = new ArrayList<>();
    for (Waypoint end : ends.values()) {
      Matcher name = NAME.matcher(end.name());
      if (name.matches()) {
        boolean isFirst = name.group(2).equals("A");
        String otherName = name.group(1) + (isFirst ? "-B_" : "-A_") + name.group(3);
        Waypoint other = ends.get(otherName);
        if (other == null) {
          throw bad(end, "has no " + otherName);
        }
        if (isFirst) {
          add(end, other, Integer.parseInt(name.group(3)), lines);
        }
      }
    }
    return lines;
  }

  private void add(Waypoint a, Waypoint b, int widthUnits, List<Line> lines) {
    double rgb = a.angle();
    if (rgb != StrictMath.rint(rgb) || rgb < 0 || rgb > Ink.MAX_RGB) {
      throw bad(a, "has a third column that is no colour, 0 to 16777215");
    }
    if (b.angle() != rgb) {
      throw bad(b, "has another colour than " + a.name());
    }
    if (widthUnits == 0) {
      throw bad(a, "has no width");
    }
    Point from = whole(a);
    Point to = whole(b);
    if (!from.equals(to)) {
      Ink ink = new Ink((int) rgb, StrictMath.max(1, StrictMath.rint(widthUnits * mmPerUnit)));
      lines.add(new Line(new Polyline(List.of(from, to)), ink));
    }
  }

  private static Point whole(Waypoint end) {
    return new Point(StrictMath.rint(end.xMm()), StrictMath.rint(end.yMm()));
  }

  private BadInput bad(Waypoint end, String why) {
    return new BadInput(
        file
            + ":"
            + lineOf(end.name())
            + ": '"
            + end.name()
            + "' "
            + why
            + ": expected "
            + EXPECTED);
  }

  /** The last line of the file that has this name. */
  private int lineOf(String name) {
    int line = 0;
    int found = 1;
    for (String each : text.split("\r\n|\r|\n", -1)) {
      line++;
      String[] fields = each.split(",", -1);
      if (fields.length > 4 && fields[4].strip().equals(name)) {
        found = line;
      }
    }
    return found;
  }
}
