package org.starl.apps.maze;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import org.starl.apps.maze.robot.Board;
import org.starl.apps.maze.robot.Layout;
import org.starl.apps.maze.robot.Places;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.random.Rng;
import org.starl.sim.world.GridMap;

/** A grid map with drawn robots, and with hidden boxes on their ways. */
final class MapMaze {

  private static final int FEWEST_STEPS = 6;

  private MapMaze() {}

  /**
   * @param boxes number of hidden boxes of one cell each, fewer if there is no room
   */
  static Layout of(GridMap map, double cellMm, int robots, int boxes, Rng rng) {
    int columns = map.columns();
    IntPredicate isFree = cell -> map.isFree(cell % columns, cell / columns);
    Board board = Board.open(columns, map.rows(), cellMm, isFree);
    Places places = new Places(board, FEWEST_STEPS, rng.fork("places"));
    int found = places.draw(robots);
    if (found < robots) {
      throw Places.noRoom(robots, found);
    }
    List<Obstacle> obstacles = new ArrayList<>(map.walls(cellMm).all());
    for (int cell : places.hideBoxes(boxes)) {
      List<Point> corners =
          Rectangle.around(board.middle(cell), cellMm, cellMm).outline().vertices();
      obstacles.add(new Obstacle(corners, true, true, Obstacle.FOREVER));
    }
    return new Layout(board.floor(), new Obstacles(obstacles), places.robots());
  }
}
