package org.starl.apps.maze;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.random.Rng;

/**
 * A maze drawn from the seed: random walks join the cells to a tree, then some walls are removed so that
 * there are several ways, and one cell is walled in.
 */
final class DrawnMaze {

  private static final int COLUMNS = 8;

  // More robots than this need a longer maze, so that none blocks another's only way.
  private static final int MANY_ROBOTS = 6;

  private static final int COLUMNS_FOR_MANY = 12;
  private static final int ROWS = 6;
  private static final double CELL_MM = 1_000;
  private static final Point ORIGIN = new Point(0, 0);
  private static final double REMOVED = 0.15;
  private static final int FEWEST_STEPS = 5;
  private static final int MOST_STEPS = 60;

  // A maze may have too few places far apart: then another one is drawn, up to so many.
  private static final int MAZES = 10;

  // Length in cells of a piece of wall that is known or hidden as a whole, at most.
  private static final int LONGEST_WALL = 2;

  private final int columns;
  private final Board board;
  private final Rng rng;

  private DrawnMaze(int columns, Rng rng) {
    this.columns = columns;
    board = new Board(columns, ROWS, CELL_MM);
    this.rng = rng;
  }

  /**
   * @param hidden the part of the walls that is on no map
   * @throws org.starl.input.BadInput if there is no room for so many robots
   */
  static Layout draw(int robots, double hidden, Rng rng) {
    Rng walls = rng.fork("walls");
    Rng draw = rng.fork("places");
    int most = 0;
    for (int i = 0; i < MAZES; i++) {
      DrawnMaze maze = new DrawnMaze(robots > MANY_ROBOTS ? COLUMNS_FOR_MANY : COLUMNS, walls);
      maze.build();
      Places places = new Places(maze.board, FEWEST_STEPS, MOST_STEPS, draw);
      int found = places.draw(robots);
      if (found == robots) {
        Obstacles obstacles = maze.walls(hidden, rng.fork("hidden"));
        return new Layout(maze.board.floor(), obstacles, places.robots());
      }
      most = Math.max(most, found);
    }
    throw Places.noRoom(robots, most);
  }

  private void build() {
    for (int cell = 0; cell < board.cells(); cell++) {
      for (int next : board.neighbours(cell)) {
        board.setWall(cell, next, true);
      }
    }
    joinAll();
    for (int cell = 0; cell < board.cells(); cell++) {
      for (int next : board.neighbours(cell)) {
        if (next > cell && rng.nextBoolean(REMOVED)) {
          board.setWall(cell, next, false);
        }
      }
    }
    int closed = rng.nextInt(board.cells());
    for (int next : board.neighbours(closed)) {
      board.setWall(closed, next, true);
    }
  }

  private void joinAll() {
    BitSet joined = new BitSet();
    ArrayDeque<Integer> walk = new ArrayDeque<>();
    walk.push(0);
    joined.set(0);
    while (!walk.isEmpty()) {
      int cell = walk.element();
      List<Integer> choice = new ArrayList<>(board.neighbours(cell));
      choice.removeIf(joined::get);
      if (choice.isEmpty()) {
        walk.pop();
      } else {
        int next = choice.get(rng.nextInt(choice.size()));
        board.setWall(cell, next, false);
        joined.set(next);
        walk.push(next);
      }
    }
  }

  private Obstacles walls(double hidden, Rng draw) {
    Rectangle floor = board.floor();
    Point upperLeft = new Point(0, floor.yMaxMm());
    Point lowerRight = new Point(floor.xMaxMm(), 0);
    Point upperRight = new Point(floor.xMaxMm(), floor.yMaxMm());
    List<Obstacle> walls = new ArrayList<>();
    walls.add(Obstacle.wall(ORIGIN, lowerRight, upperRight, upperLeft, ORIGIN));
    for (int column = 0; column < columns - 1; column++) {
      addLine(walls, column, 1, columns, ROWS, hidden, draw);
    }
    for (int row = 0; row < ROWS - 1; row++) {
      addLine(walls, row * columns, columns, 1, columns, hidden, draw);
    }
    return new Obstacles(walls);
  }

  /** Adds the walls on one line, between each cell and its neighbour across the line. */
  private void addLine(
      List<Obstacle> walls, int first, int across, int along, int count, double hidden, Rng draw) {
    int from = 0;
    while (from < count) {
      int to = from;
      while (to < count
          && to - from < LONGEST_WALL
          && board.hasWall(first + to * along, first + to * along + across)) {
        to++;
      }
      if (to > from) {
        walls.add(wall(first, across, from, to, draw.nextBoolean(hidden)));
      }
      from = Math.max(to, from + 1);
    }
  }

  private Obstacle wall(int first, int across, int from, int to, boolean isHidden) {
    boolean isUpright = across == 1;
    int line = isUpright ? first + 1 : first / columns + 1;
    double off = line * CELL_MM;
    Point a = isUpright ? new Point(off, from * CELL_MM) : new Point(from * CELL_MM, off);
    Point b = isUpright ? new Point(off, to * CELL_MM) : new Point(to * CELL_MM, off);
    return new Obstacle(List.of(a, b), false, isHidden, Obstacle.FOREVER);
  }
}
