package org.starl.apps.maze;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.random.Rng;

/**
 * A maze drawn by seed: cells joined to a tree by walks at random, some walls taken away again so that
 * there are several ways, and one cell walled in.
 */
final class DrawnMaze {

  private static final int COLUMNS = 8;

  /** More than so many robots need a longer maze, so that nobody is in another's only way. */
  private static final int MANY_ROBOTS = 6;

  private static final int COLUMNS_FOR_MANY = 12;
  private static final int ROWS = 6;
  private static final double CELL_MM = 1_000;
  private static final double TAKEN_AWAY = 0.15;
  private static final int FEWEST_STEPS = 5;
  private static final int MOST_STEPS = 60;

  /** So many are drawn, and found too small, before that is said: one may have few places far apart. */
  private static final int MAZES = 10;

  /** A wall is known or hidden as a whole, up to so many cells long. */
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
   * @param hidden the part of the walls that nobody is told of
   * @throws org.starl.input.BadInput if so many robots find no room
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
        if (next > cell && rng.nextBoolean(TAKEN_AWAY)) {
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
    List<Obstacle> walls = new ArrayList<>();
    double width = columns * CELL_MM;
    double height = ROWS * CELL_MM;
    walls.add(
        Obstacle.wall(
            new Point(0, 0),
            new Point(width, 0),
            new Point(width, height),
            new Point(0, height),
            new Point(0, 0)));
    for (int column = 0; column < columns - 1; column++) {
      addLine(walls, column, 1, columns, ROWS, hidden, draw);
    }
    for (int row = 0; row < ROWS - 1; row++) {
      addLine(walls, row * columns, columns, 1, columns, hidden, draw);
    }
    return new Obstacles(walls);
  }

  /** The walls on one line, between each cell and the one across it. */
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
