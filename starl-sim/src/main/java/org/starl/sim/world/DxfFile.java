package org.starl.sim.world;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.input.Field;
import org.starl.input.TextFile;

/**
 * Reads a floor's walls from a drawing in ASCII DXF: LINE, LWPOLYLINE, POLYLINE, ARC and CIRCLE of the
 * model space, of all layers, each as known walls that always exist. Arcs become lines at most 5 mm from them. A
 * closed line encloses a room: its inside is not solid. Text, dimensions, points and hatches are left out; any
 * other entity, an entity without its coordinates, and a drawing without units, causes a {@link BadInput} with file and line.
 */
final class DxfFile {

  private static final String EXPECTED = "expected a drawing in ASCII DXF";
  private static final String UNITS =
      "expected $INSUNITS 1 (inches), 2 (feet), 4 (mm), 5 (cm) or 6 (m)";
  private static final String ENTITIES = "expected LINE, LWPOLYLINE, POLYLINE, ARC or CIRCLE";
  private static final Field<Double> NUMBER = Field.decimal("", -1e99, 1e99, "");
  private static final Map<String, Double> MM_BY_UNIT =
      Map.of("1", 25.4, "2", 304.8, "4", 1.0, "5", 10.0, "6", 1000.0, "14", 100.0);
  private static final Set<String> LEFT_OUT =
      Set.of("TEXT", "MTEXT", "DIMENSION", "LEADER", "POINT", "HATCH", "VIEWPORT");
  private static final Set<Integer> USED =
      Set.of(10, 11, 20, 21, 40, 42, 50, 51, 67, 70, 210, 220, 230);
  private static final double FLATNESS_MM = 5;
  private static final double MOST_MM = 1e7;
  private static final int MOST_POINTS = 100_000;

  /** Below it, an arc between two places of a floor is less than {@link #FLATNESS_MM} from its chord. */
  private static final double LEAST_BULGE = 1e-7;

  private static final int CLOSED = 1;
  private static final int MESH = 16 | 64;

  /** A corner of the frame of a spline, which is not on the curve. */
  private static final int FRAME = 16;

  private final String file;
  private final String[] lines;
  private final List<Obstacle> walls = new ArrayList<>();
  private double mmPerUnit;
  private int points;

  /** Where the entity in use begins. */
  private int line;

  /** The pair in use: a group code and its value, which is in line {@code at}. */
  private int at;

  private String code = "";
  private String value = "";

  /** A corner of a polyline; the way to the next is an arc of four times atan(bulge). */
  private static final class Corner {
    double x;
    double y = Double.NaN;
    double bulge;
  }

  private DxfFile(String file, String text) {
    this.file = file;
    lines = text.split("\r\n|\r|\n");
  }

  static Obstacles read(Path path) {
    // Up to release 2004 a drawing has characters of Windows, but all that is read is ASCII.
    String text = new String(TextFile.bytes(path, EXPECTED), StandardCharsets.ISO_8859_1);
    if (text.indexOf('\0') >= 0) {
      throw new BadInput(path + ": is not text; " + EXPECTED);
    }
    return parse(path.toString(), text.startsWith("\u00ef\u00bb\u00bf") ? text.substring(3) : text);
  }

  static Obstacles parse(String file, String text) {
    DxfFile drawing = new DxfFile(file, text);
    boolean hasEntities = false;
    drawing.next();
    while (!drawing.is("0", "EOF")) {
      boolean isSection = drawing.is("0", "SECTION");
      boolean isUnit = drawing.is("9", "$INSUNITS");
      drawing.next();
      if (isUnit) {
        drawing.unit();
      } else if (isSection && drawing.is("2", "ENTITIES")) {
        drawing.entities();
        hasEntities = true;
      }
    }
    if (!hasEntities) {
      throw new BadInput(file + ": has no section ENTITIES; " + EXPECTED);
    }
    if (drawing.walls.isEmpty()) {
      throw new BadInput(file + ": has no wall: " + ENTITIES + " in its model space");
    }
    return new Obstacles(drawing.walls);
  }

  private void unit() {
    mmPerUnit = MM_BY_UNIT.getOrDefault(value, 0.0);
    if (mmPerUnit == 0 && !value.equals("0")) {
      throw BadInput.at(file, at, BadInput.quote(value) + ": " + UNITS);
    }
  }

  private boolean is(String code, String value) {
    return this.code.equals(code) && this.value.equals(value);
  }

  /** Reads the next pair that is no comment. */
  private void next() {
    do {
      pair();
    } while (code.equals("999"));
  }

  private void pair() {
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
      throw new BadInput(file + ": has no unit: " + UNITS);
    }
    next();
    while (!is("0", "ENDSEC")) {
      String type = value;
      line = at;
      if (type.equals("EOF")) {
        throw BadInput.at(file, line, "'EOF': expected ENDSEC, the end of the entities");
      }
      List<Corner> corners = new ArrayList<>();
      double[] numbers = entity(corners);
      if (type.equals("POLYLINE")) {
        corners.clear(); // the height of all
        while (is("0", "VERTEX")) {
          boolean isFrame = ((int) entity(corners)[70] & FRAME) != 0;
          if (isFrame && !corners.isEmpty()) {
            corners.removeLast();
          }
        }
        if (is("0", "SEQEND")) {
          entity(new ArrayList<>());
        }
      }
      if (numbers[67] == 0 && !LEFT_OUT.contains(type)) {
        boolean isTilted =
            numbers[230] < 0 || Math.abs(numbers[210]) + Math.abs(numbers[220]) > 1e-9;
        if (isTilted && !type.equals("LINE")) { // the ends of a line are in the drawing's own axes
          throw wrong(type + ": expected it seen from above (group 230)");
        }
        add(type, corners, numbers);
      }
    }
  }

  /**
   * The entity that begins here.
   *
   * @param corners gets those of groups 10 and 20
   * @return the numbers by their groups; for those that it lacks NaN up to group 59, then 0
   */
  private double[] entity(List<Corner> corners) {
    double[] numbers = new double[231];
    Arrays.fill(numbers, 0, 60, Double.NaN);
    for (next(); !code.equals("0"); next()) {
      int group = Integer.parseInt(code);
      if (!USED.contains(group)) {
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
    Double number = NUMBER.reader().apply(value);
    if (number == null) {
      throw BadInput.at(file, at, BadInput.quote(value) + ": expected a number");
    }
    if (Math.abs(number) * mmPerUnit > MOST_MM && !List.of("42", "50", "51", "70").contains(code)) {
      throw BadInput.at(file, at, BadInput.quote(value) + ": expected at most 10 km");
    }
    return number;
  }

  private void add(String type, List<Corner> corners, double[] numbers) {
    List<Point> way = new ArrayList<>();
    switch (type) {
      case "LINE" -> {
        require(type, numbers, 10, 20, 11, 21);
        way.add(mm(numbers[10], numbers[20]));
        way.add(mm(numbers[11], numbers[21]));
      }
      case "CIRCLE" -> addCurve(way, type, numbers, 0, 360);
      case "ARC" -> {
        require(type, numbers, 50, 51);
        double turn = (numbers[51] - numbers[50]) % 360;
        addCurve(way, type, numbers, numbers[50], turn > 0 ? turn : turn + 360);
      }
      case "LWPOLYLINE", "POLYLINE" -> {
        if (((int) numbers[70] & MESH) != 0) {
          throw wrong(type + ": expected a line, no mesh");
        }
        addAll(way, corners, ((int) numbers[70] & CLOSED) != 0);
      }
      default ->
          throw wrong(
              BadInput.quote(type)
                  + ": "
                  + ENTITIES
                  + "; explode blocks (INSERT) and other curves in the program that drew them");
    }
    requireRoom(way.size());
    points += way.size();
    if (way.stream().distinct().count() > 1) {
      walls.add(Obstacle.wall(way.toArray(new Point[0])));
    }
  }

  private void require(String type, double[] numbers, int... groups) {
    for (int group : groups) {
      if (Double.isNaN(numbers[group])) {
        throw wrong(type + ": has no group " + group + ": expected a number there");
      }
    }
  }

  private void requireRoom(double more) {
    if (points + more > MOST_POINTS) {
      throw wrong("expected at most " + MOST_POINTS + " points of walls");
    }
  }

  /** An error of the entity in use. */
  private BadInput wrong(String text) {
    return BadInput.at(file, line, text);
  }

  private Point mm(double x, double y) {
    return new Point(x * mmPerUnit, y * mmPerUnit);
  }

  private void addAll(List<Point> way, List<Corner> corners, boolean isClosed) {
    for (int i = 0; i < corners.size(); i++) {
      Corner corner = corners.get(i);
      if (Double.isNaN(corner.y)) {
        throw wrong("corner " + (i + 1) + " has no group 20: expected a number there");
      }
      Point from = mm(corner.x, corner.y);
      Corner next = corners.get((i + 1) % corners.size());
      way.add(from);
      if (i + 1 == corners.size() && !isClosed) {
        return;
      }
      Point chord = mm(next.x, next.y).minus(from);
      if (Math.abs(corner.bulge) > LEAST_BULGE && chord.normMm() > 0) {
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

  /** Angles in degrees. */
  private void addCurve(
      List<Point> way, String type, double[] numbers, double fromDeg, double turnDeg) {
    require(type, numbers, 10, 20, 40);
    Point center = mm(numbers[10], numbers[20]);
    double radius = numbers[40] * mmPerUnit;
    if (radius <= 0) {
      throw wrong(type + ": expected a radius (group 40) above 0");
    }
    double from = StrictMath.toRadians(fromDeg);
    double turn = StrictMath.toRadians(turnDeg);
    way.add(center.plus(polar(radius, from)));
    addArc(way, center, radius, from, turn);
    way.add(center.plus(polar(radius, from + turn)));
  }

  /**
   * Adds what is between the ends of an arc.
   *
   * @param radius negative, as {@code turn} is, for a centre at the right of the way
   */
  private void addArc(List<Point> way, Point center, double radius, double from, double turn) {
    double r = Math.max(Math.abs(radius), FLATNESS_MM);
    double most = 2 * StrictMath.acos(1 - FLATNESS_MM / r);
    double steps = Math.max(3, StrictMath.ceil(Math.abs(turn) / most));
    requireRoom(way.size() + steps);
    for (int i = 1; i < steps; i++) {
      way.add(center.plus(polar(radius, from + turn * i / steps)));
    }
  }
}
