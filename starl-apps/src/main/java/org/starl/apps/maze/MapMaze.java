package org.starl.apps.maze;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.random.Rng;
import org.starl.sim.world.GridMap;

/** A grid map with drawn robots, and with hidden boxes on their ways. */
final class MapMaze {

  private static final int FEWEST_STEPS = 6;
  private static final int MOST_STEPS = 60;

  private MapMaze() {}

  /**
   * @param boxes number of hidden boxes of one cell each, fewer if there is no room
   */
  static Layout draw(GridMap map, double cellMm, int robots, int boxes, Rng rng) {
    Board board = new Board(map.columns(), map.rows(), cellMm);
    for (int cell = 0; cell < board.cells(); cell++) {
      board.setFree(cell, map.isFree(cell % map.columns(), cell / map.columns()));
    }
    Places places = new Places(board, FEWEST_STEPS, MOST_STEPS, rng.fork("places"));
    int found = places.draw(robots);
    if (found < robots) {
      throw Places.noRoom(robots, found);
    }
    List<Obstacle> all = new ArrayList<>(map.walls(cellMm).all());
    places.hideBoxes(boxes).forEach(cell -> all.add(box(board.middle(cell), cellMm / 2)));
    return new Layout(board.floor(), new Obstacles(all), places.robots());
  }

  private static Obstacle box(Point middle, double halfMm) {
    double x = middle.xMm();
    double y = middle.yMm();
    List<Point> corners =
        List.of(
            new Point(x - halfMm, y - halfMm),
            new Point(x + halfMm, y - halfMm),
            new Point(x + halfMm, y + halfMm),
            new Point(x - halfMm, y + halfMm));
    return new Obstacle(corners, true, true, Obstacle.FOREVER);
  }
}
