package org.starl.sim.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/**
 * Reads the waypoint files of StarL's demo apps: one item per line, mm and degrees.
 *
 * <pre>
 * WAY,x,y,angle,name[,radius]
 * SENSE,x,y,angle,name[,radius]
 * Obstacle;x,y;x,y[;x,y ...];lifetime     two corners: a wall, more: a solid body
 * Hidden;x,y;x,y[;x,y ...];lifetime       the same, unknown to robots
 * // a comment
 * </pre>
 *
 * The lifetime is in ms, -1 for ever. Blank lines, blanks around fields, LF or CRLF line ends and a
 * missing last line end are accepted. Any other text causes a {@link BadInput} with file, line and
 * the expected text.
 */
public final class WaypointFiles {

  private static final Pattern NUMBER = Pattern.compile("[+-]?[0-9]{1,9}(\\.[0-9]{1,9})?");
  private static final Pattern LIFETIME = Pattern.compile("-1|[0-9]{1,12}");
  private static final int LONGEST_NAME = 200;
  private static final String WAY = "WAY,x,y,angle,name[,radius]";
  private static final String SENSE = "SENSE,x,y,angle,name[,radius]";
  private static final String OBSTACLE = "Obstacle;x,y;x,y[;x,y];lifetime";
  private static final String HIDDEN = "Hidden;x,y;x,y[;x,y];lifetime";

  private final String file;
  private final List<Waypoint> waypoints = new ArrayList<>();
  private final List<Waypoint> sensePoints = new ArrayList<>();
  private final List<Obstacle> obstacles = new ArrayList<>();

  private WaypointFiles(String file) {
    this.file = file;
  }

  /**
   * Reads a file.
   *
   * @throws BadInput if the file is missing, not text, or has a line in another format
   */
  public static WaypointFile read(Path path) {
    String expected = "expected a waypoint file with lines such as " + WAY;
    return parse(path.toString(), TextFile.read(path, expected));
  }

  /**
   * The obstacles of a file: of a waypoint file, or of a drawing in DXF, whose name ends with {@code .dxf}.
   *
   * @throws BadInput if the file is missing, not text, or has anything that is refused
   */
  public static Obstacles obstacles(Path path) {
    boolean isDrawing = path.toString().toLowerCase(Locale.ROOT).endsWith(".dxf");
    return isDrawing ? DxfFile.read(path) : read(path).obstacles();
  }

  /**
   * Reads a file's text.
   *
   * @param file the file's name, for errors
   */
  public static WaypointFile parse(String file, String text) {
    WaypointFiles reader = new WaypointFiles(file);
    int number = 0;
    for (String line : text.split("\r\n|\r|\n", -1)) {
      number++;
      reader.line(number, line.strip());
    }
    return new WaypointFile(reader.waypoints, reader.sensePoints, new Obstacles(reader.obstacles));
  }

  private void line(int number, String line) {
    if (line.isEmpty() || line.startsWith("//")) {
      return;
    }
    if (line.startsWith("WAY,")) {
      waypoints.add(waypoint(number, line, WAY));
    } else if (line.startsWith("SENSE,")) {
      sensePoints.add(waypoint(number, line, SENSE));
    } else if (line.startsWith("Obstacle;")) {
      obstacles.add(obstacle(number, line, OBSTACLE, false));
    } else if (line.startsWith("Hidden;")) {
      obstacles.add(obstacle(number, line, HIDDEN, true));
    } else {
      throw broken(number, line, String.join(" or ", WAY, SENSE, OBSTACLE, HIDDEN, "// a comment"));
    }
  }

  private Waypoint waypoint(int number, String line, String form) {
    String[] fields = line.split(",", -1);
    if (fields.length < 5 || fields.length > 6 || fields[4].isBlank()) {
      throw broken(number, line, form);
    }
    if (fields[4].length() > LONGEST_NAME) {
      throw broken(number, line, form + " with a name of at most " + LONGEST_NAME + " characters");
    }
    return new Waypoint(
        fields[4].strip(),
        number(number, line, fields[1], form),
        number(number, line, fields[2], form),
        number(number, line, fields[3], form),
        fields.length == 5 ? OptionalDouble.empty() : radius(number, line, fields[5], form),
        number);
  }

  private OptionalDouble radius(int number, String line, String field, String form) {
    double radiusMm = number(number, line, field, form);
    if (radiusMm < 0) {
      throw broken(number, line, form + " with a radius of at least 0");
    }
    return OptionalDouble.of(radiusMm);
  }

  private Obstacle obstacle(int number, String line, String form, boolean hidden) {
    String[] fields = line.split(";", -1);
    int corners = fields.length - 2;
    if (corners < 2) {
      throw broken(number, line, form + " with two corners or more");
    }
    List<Point> points = new ArrayList<>();
    for (int i = 1; i <= corners; i++) {
      String[] coordinates = fields[i].split(",", -1);
      if (coordinates.length != 2) {
        throw broken(number, line, form + ", but " + BadInput.quote(fields[i]) + " is not x,y");
      }
      double xMm = number(number, line, coordinates[0], form);
      points.add(new Point(xMm, number(number, line, coordinates[1], form)));
    }
    String lifetime = fields[corners + 1].strip();
    if (!LIFETIME.matcher(lifetime).matches()) {
      throw broken(number, line, form + " with a lifetime in whole ms, or -1 for ever");
    }
    try {
      if (corners > 2) {
        new Polygon(points);
      }
    } catch (IllegalArgumentException e) {
      throw broken(number, line, form + " around a body whose sides do not cross or touch");
    }
    return new Obstacle(points, corners > 2, hidden, Long.parseLong(lifetime));
  }

  private double number(int number, String line, String field, String form) {
    String stripped = field.strip();
    if (!NUMBER.matcher(stripped).matches()) {
      throw broken(number, line, form + ", but " + BadInput.quote(stripped) + " is not a number");
    }
    return Double.parseDouble(stripped);
  }

  private BadInput broken(int number, String line, String expected) {
    return new BadInput(
        file + ":" + number + ": " + BadInput.quote(line) + ": expected " + expected);
  }
}
