package org.starl.sim.world;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.starl.input.BadInput;
import org.starl.input.Field;
import org.starl.input.Quantities;
import org.starl.input.TextFile;

/**
 * Reads the lists of starts and goals that the path-finding benchmarks of MovingAI have beside their maps. A
 * list begins with {@code version 1}. A line has a number, the map's name, its width and height in
 * cells, column and row of the start and of the goal from the upper left, from 0, and the length of a
 * way, which is not used.
 */
public final class GridTrips {

  private static final String EXPECTED =
      "expected BUCKET MAP WIDTH HEIGHT STARTX STARTY GOALX GOALY LENGTH";

  private static final Field<Double> LENGTH = Field.decimal("", 0, 1e9, "");

  private GridTrips() {}

  /**
   * From one free cell to another.
   *
   * @param line of the file, from 1
   * @param text of that line
   * @param from cell (column, row) is number {@code row * columns + column}
   */
  public record Trip(int line, String text, int from, int to) {}

  /** Whether a text is such a list. */
  public static boolean isList(String text) {
    return text.strip().startsWith("version");
  }

  /**
   * The trips of a file, in its order.
   *
   * @param most so many are read; the form of the others is checked
   * @throws BadInput if the file cannot be read, or does not fit the map
   */
  public static List<Trip> read(Path file, GridMap map, int most) {
    String text = TextFile.read(file, EXPECTED);
    List<String> lines = text.lines().toList();
    String first = lines.isEmpty() ? "" : lines.get(0).strip();
    if (!first.matches("version\\s+1(\\.0+)?")) {
      throw wrong(file, 1, first, "expected 'version 1'");
    }
    List<Trip> trips = new ArrayList<>();
    for (int i = 1; i < lines.size(); i++) {
      String line = lines.get(i).strip();
      if (line.isEmpty()) {
        continue;
      }
      String[] words = line.split(line.contains("\t") ? "\t" : "\\s+", -1);
      if (words.length != 9) {
        throw wrong(file, i + 1, line, EXPECTED);
      }
      try {
        Quantities.whole(words[0], 0, Long.MAX_VALUE);
        if (LENGTH.reader().apply(words[8]) == null) {
          throw new BadInput(BadInput.quote(words[8]) + ": expected a number of at least 0");
        }
        if (trips.size() == most) {
          continue;
        }
        Quantities.whole(words[2], map.columns(), map.columns());
        Quantities.whole(words[3], map.rows(), map.rows());
        trips.add(
            new Trip(i + 1, line, cell(map, words[4], words[5]), cell(map, words[6], words[7])));
      } catch (BadInput error) {
        throw Quantities.in(file + ":" + (i + 1), error);
      }
    }
    return trips;
  }

  private static int cell(GridMap map, String x, String y) {
    int column = (int) Quantities.whole(x, 0, map.columns() - 1);
    int row = map.rows() - 1 - (int) Quantities.whole(y, 0, map.rows() - 1);
    if (!map.isFree(column, row)) {
      throw new BadInput(BadInput.quote(x + " " + y) + ": expected a free cell of the map");
    }
    return row * map.columns() + column;
  }

  private static BadInput wrong(Path file, int line, String given, String expected) {
    return BadInput.at(file.toString(), line, BadInput.quote(given) + ": " + expected);
  }
}
