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
import org.starl.random.Rng;
import org.starl.sim.world.GridMap;
import org.starl.sim.world.GridTrips;

/**
 * A grid map with robots, drawn or from a list of {@link GridTrips}, and with hidden boxes on their
 * ways.
 */
final class MapMaze {

  private static final int FEWEST_STEPS = 6;

  // A way on a floor with as many takes minutes to plan.
  private static final int MOST_WALLS = 80_000;

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
    List<GridTrips.Trip> trips = GridTrips.read(scen, map, robots);
    for (GridTrips.Trip trip : trips) {
      if (!places.add(trip.from(), trip.to())) {
        throw BadInput.at(
            scen.toString(),
            trip.line(),
            BadInput.quote(trip.text())
                + ": expected a start and a goal off the ways of other robots");
      }
    }
    if (trips.size() < robots) {
      throw new BadInput(
          scen + ": " + trips.size() + " starts: expected " + robots + ", one per robot");
    }
  }
}
