package org.starl.apps.maze;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import org.jspecify.annotations.Nullable;
import org.starl.apps.maze.robot.Board;
import org.starl.apps.maze.robot.Layout;
import org.starl.apps.maze.robot.Places;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.input.TextFile;
import org.starl.random.Rng;
import org.starl.sim.world.GridMap;

/**
 * A grid map with robots, drawn or from a list of the path-finding benchmarks, and with hidden boxes on
 * their ways. A list begins with {@code version 1}. A line has a number, the map's name, its width and
 * height in cells, column and row of the start and of the goal from the upper left, from 0, and the length of a way, which
 * is not used.
 */
final class MapMaze {

  private static final int FEWEST_STEPS = 6;

  // A way on a floor with as many takes minutes to plan.
  private static final int MOST_WALLS = 80_000;

  private static final String EXPECTED =
      "expected BUCKET MAP WIDTH HEIGHT STARTX STARTY GOALX GOALY LENGTH";

  private MapMaze() {}

  /**
   * @param scen the list of starts and goals; null to draw them
   * @param boxes number of hidden boxes of one cell each, fewer if there is no room
   */
  static Layout of(
      GridMap map, @Nullable Path scen, double cellMm, int robots, int boxes, Rng rng) {
    int columns = map.columns();
    List<Obstacle> obstacles = new ArrayList<>(map.walls(cellMm).all());
    if (obstacles.size() > MOST_WALLS) {
      String walls = obstacles.size() + " rectangles of blocked cells";
      throw new BadInput("map: " + walls + ": expected at most " + MOST_WALLS);
    }
    IntPredicate isFree = cell -> map.isFree(cell % columns, cell / columns);
    Board board = Board.open(columns, map.rows(), cellMm, isFree);
    Places places = new Places(board, FEWEST_STEPS, rng.fork("places"));
    if (scen != null) {
      read(scen, map, robots, places);
    } else {
      int found = places.draw(robots);
      if (found < robots) {
        throw Places.noRoom(robots, found, FEWEST_STEPS);
      }
    }
    for (int cell : places.hideBoxes(boxes)) {
      List<Point> corners =
          Rectangle.around(board.middle(cell), cellMm, cellMm).outline().vertices();
      obstacles.add(new Obstacle(corners, true, true, Obstacle.FOREVER));
    }
    return new Layout(board.floor(), new Obstacles(obstacles), places.robots());
  }

  private static void read(Path scen, GridMap map, int robots, Places places) {
    String[] lines = TextFile.read(scen, EXPECTED).split("\r\n|\r|\n", -1);
    if (!lines[0].strip().matches("version\\s+1(\\.0)?")) {
      throw wrong(scen, 1, lines[0], "expected 'version 1'");
    }
    int found = 0;
    for (int i = 1; i < lines.length && found < robots; i++) {
      String line = lines[i].strip();
      if (line.isEmpty()) {
        continue;
      }
      String[] words = line.split(line.contains("\t") ? "\t" : "\\s+", -1);
      if (words.length != 9) {
        throw wrong(scen, i + 1, line, EXPECTED);
      }
      try {
        Quantities.whole(words[2], map.columns(), map.columns());
        Quantities.whole(words[3], map.rows(), map.rows());
        if (!places.add(cell(map, words[4], words[5]), cell(map, words[6], words[7]))) {
          throw new BadInput(
              BadInput.quote(line) + ": expected a start and a goal off the ways of other robots");
        }
      } catch (BadInput error) {
        throw Quantities.in(scen + ":" + (i + 1), error);
      }
      found++;
    }
    if (found < robots) {
      throw new BadInput(scen + ": " + found + " starts: expected " + robots + ", one per robot");
    }
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
