package org.starl.sim.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/**
 * Reads a floor's walls from a drawing in ASCII DXF: LINE, LWPOLYLINE, POLYLINE, ARC and CIRCLE of the
 * model space, of all layers, each as known walls that always exist. Arcs become lines at most 5 mm from them. A
 * closed line encloses a room: its inside is not solid. Text, dimensions, points and hatches are left out; any
 * other entity, and a drawing without units, causes a {@link BadInput} with file and line.
 */
final class DxfFile {

  private static final String EXPECTED = "expected a drawing in ASCII DXF";
  private static final Map<String, Double> MM_BY_UNIT =
      Map.of("1", 25.4, "2", 304.8, "4", 1.0, "5", 10.0, "6", 1000.0, "14", 100.0);
  private static final Set<String> LEFT_OUT =
      Set.of("TEXT", "MTEXT", "DIMENSION", "LEADER", "POINT", "HATCH", "VIEWPORT");
  private static final double FLATNESS_MM = 5;
  private static final double MOST_MM = 1e7;
  private static final int MOST_POINTS = 100_000;

  private static final int CLOSED = 1;
  private static final int MESH = 16 | 64;

  private final String file;
  private final String[] lines;
  private final List<Obstacle> walls = new ArrayList<>();
  private double mmPerUnit;
  private int points;

  /** The pair in use: a group code and its value, which is in line {@code at}. */
  private int at;

  private String code = "";
  private String value = "";

  /** A corner of a polyline; the way to the next is an arc of four times atan(bulge). */
  private static final class Corner {
    double x;
    double y;
    double bulge;
  }

  private DxfFile(String file, String text) {
    this.file = file;
    lines = text.split("\r\n|\r|\n");
  }

  static Obstacles read(Path path) {
    return parse(path.toString(), TextFile.read(path, EXPECTED));
  }

  static Obstacles parse(String file, String text) {
    DxfFile drawing = new DxfFile(file, text);
    drawing.next();
    while (!drawing.is("0", "EOF")) {
      if (drawing.is("9", "$INSUNITS")) {
        drawing.next();
        drawing.mmPerUnit = MM_BY_UNIT.getOrDefault(drawing.value, 0.0);
      } else if (drawing.is("2", "ENTITIES")) {
        drawing.entities();
        continue;
      }
      drawing.next();
    }
    return new Obstacles(drawing.walls);
  }

  private boolean is(String code, String value) {
    return this.code.equals(code) && this.value.equals(value);
  }

  private void next() {
    if (at + 2 > lines.length) {
      throw BadInput.at(file, lines.length, "the file ends: " + EXPECTED + ", up to its line EOF");
    }
    code = lines[at].strip();
    value = lines[at + 1].strip();
    at += 2;
    if (!code.matches("[0-9]{1,4}")) {
      throw BadInput.at(file, at - 1, BadInput.quote(code) + ": expected the number of a group");
    }
  }

  private void entities() {
    if (mmPerUnit == 0) {
      throw new BadInput(
          file + ": has no unit: expected $INSUNITS 1 (inches), 2 (feet), 4 (mm), 5 (cm) or 6 (m)");
    }
    next();
    while (!is("0", "ENDSEC")) {
      String type = value;
      int line = at;
      List<Corner> corners = new ArrayList<>();
      double[] numbers = entity(corners);
      if (type.equals("POLYLINE")) {
        corners.clear(); // the height of all
        while (is("0", "VERTEX")) {
          entity(corners);
        }
        if (is("0", "SEQEND")) {
          entity(new ArrayList<>());
        }
      }
      if (numbers[67] == 0 && !LEFT_OUT.contains(type)) {
        if (numbers[230] < 0) {
          throw BadInput.at(file, line, type + ": expected it seen from above (group 230)");
        }
        add(type, line, corners, numbers);
      }
    }
  }

  /**
   * The entity that begins here.
   *
   * @param corners gets those of groups 10 and 20
   * @return the numbers by their groups; 0 for those that it lacks
   */
  private double[] entity(List<Corner> corners) {
    double[] numbers = new double[231];
    for (next(); !code.equals("0"); next()) {
      int group = Integer.parseInt(code);
      boolean isUsed = (group >= 10 && group < 60) || group == 67 || group == 70 || group == 230;
      if (!isUsed) {
        continue;
      }
      numbers[group] = number();
      if (group == 10) {
        corners.add(new Corner());
        corners.getLast().x = numbers[10];
      } else if (group == 20 && !corners.isEmpty()) {
        corners.getLast().y = numbers[20];
      } else if (group == 42 && !corners.isEmpty()) {
        corners.getLast().bulge = numbers[42];
      }
    }
    return numbers;
  }

  private double number() {
    try {
      double number = Double.parseDouble(value);
      if (Math.abs(number) * mmPerUnit <= MOST_MM || code.equals("70")) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw BadInput.at(file, at, BadInput.quote(value) + ": expected a number");
    }
    throw BadInput.at(file, at, BadInput.quote(value) + ": expected at most 10 km");
  }

  private void add(String type, int line, List<Corner> corners, double[] numbers) {
    List<Point> way = new ArrayList<>();
    double radius = numbers[40] * mmPerUnit;
    Point first = mm(numbers[10], numbers[20]);
    switch (type) {
      case "LINE" -> way.addAll(List.of(first, mm(numbers[11], numbers[21])));
      case "CIRCLE" -> addCurve(way, first, radius, 0, 2 * StrictMath.PI);
      case "ARC" -> {
        double from = StrictMath.toRadians(numbers[50]);
        double turn = StrictMath.toRadians(numbers[51]) - from;
        addCurve(way, first, radius, from, turn > 0 ? turn : turn + 2 * StrictMath.PI);
      }
      case "LWPOLYLINE", "POLYLINE" -> {
        if (((int) numbers[70] & MESH) != 0) {
          throw BadInput.at(file, line, type + ": expected a line, no mesh");
        }
        addAll(way, corners, ((int) numbers[70] & CLOSED) != 0);
      }
      default ->
          throw BadInput.at(
              file,
              line,
              BadInput.quote(type)
                  + ": expected LINE, LWPOLYLINE, POLYLINE, ARC or CIRCLE; explode blocks (INSERT)"
                  + " and other curves in the program that drew them");
    }
    points += way.size();
    if (points > MOST_POINTS) {
      throw BadInput.at(file, line, "expected at most " + MOST_POINTS + " points of walls");
    }
    if (way.stream().distinct().count() > 1) {
      walls.add(Obstacle.wall(way.toArray(new Point[0])));
    }
  }

  private Point mm(double x, double y) {
    return new Point(x * mmPerUnit, y * mmPerUnit);
  }

  private void addAll(List<Point> way, List<Corner> corners, boolean isClosed) {
    for (int i = 0; i < corners.size(); i++) {
      Corner corner = corners.get(i);
      Point from = mm(corner.x, corner.y);
      Corner next = corners.get((i + 1) % corners.size());
      way.add(from);
      if (i + 1 == corners.size() && !isClosed) {
        return;
      }
      Point chord = mm(next.x, next.y).minus(from);
      if (corner.bulge != 0 && chord.normMm() > 0) {
        double turn = 4 * StrictMath.atan(corner.bulge);
        double radius = chord.normMm() / (2 * StrictMath.sin(turn / 2));
        double toCenter = chord.angleRad() + (StrictMath.PI - turn) / 2;
        Point center = from.plus(polar(radius, toCenter));
        addArc(way, center, radius, toCenter + StrictMath.PI, turn);
      }
      if (i + 1 == corners.size()) {
        way.add(mm(next.x, next.y));
      }
    }
  }

  private static Point polar(double radius, double angle) {
    return new Point(radius * StrictMath.cos(angle), radius * StrictMath.sin(angle));
  }

  private static void addCurve(
      List<Point> way, Point center, double radius, double from, double turn) {
    way.add(center.plus(polar(radius, from)));
    addArc(way, center, radius, from, turn);
    way.add(center.plus(polar(radius, from + turn)));
  }

  /**
   * Adds what is between the ends of an arc.
   *
   * @param radius negative, as {@code turn} is, for a centre at the right of the way
   */
  private static void addArc(
      List<Point> way, Point center, double radius, double from, double turn) {
    double r = Math.max(Math.abs(radius), FLATNESS_MM);
    double most = 2 * StrictMath.acos(1 - FLATNESS_MM / r);
    int steps = (int) Math.max(3, StrictMath.ceil(Math.abs(turn) / most));
    for (int i = 1; i < steps; i++) {
      way.add(center.plus(polar(radius, from + turn * i / steps)));
    }
  }
}
