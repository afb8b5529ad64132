package org.starl.apps.maze.robot;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.random.Rng;

/**
 * A maze drawn from the seed: random walks join the cells to a tree, then some walls are removed so
 * that there are several ways, and one cell is walled in.
 */
public final class DrawnMaze {

  private static final int COLUMNS = 8;

  // More robots than this need a longer maze, so that none blocks another's only way.
  private static final int MANY_ROBOTS = 6;

  private static final int COLUMNS_FOR_MANY = 12;
  private static final int ROWS = 6;
  private static final double CELL_MM = 1_000;
  private static final double REMOVED = 0.15;
  private static final int FEWEST_STEPS = 5;

  // A maze may have too few places far apart: then another one is drawn, up to so many.
  private static final int MAZES = 10;

  // Length in cells of a piece of wall that is known or hidden as a whole, at most.
  private static final int LONGEST_WALL = 2;

  private DrawnMaze() {}

  /**
   * @param hidden the part of the walls that is on no map
   * @throws org.starl.input.BadInput if there is no room for so many robots
   */
  public static Layout draw(int robots, double hidden, Rng rng) {
    Rng walls = rng.fork("walls");
    Rng draw = rng.fork("places");
    int most = 0;
    for (int i = 0; i < MAZES; i++) {
      Board board = board(robots > MANY_ROBOTS ? COLUMNS_FOR_MANY : COLUMNS, walls);
      Places places = new Places(board, FEWEST_STEPS, draw);
      int found = places.draw(robots);
      if (found == robots) {
        return new Layout(board.floor(), walls(board, hidden, rng.fork("hidden")), places.robots());
      }
      most = Math.max(most, found);
    }
    throw Places.noRoom(robots, most, FEWEST_STEPS);
  }

  private static Board board(int columns, Rng rng) {
    Board board = new Board(columns, ROWS, CELL_MM, cell -> true);
    joinAll(board, rng);
    for (int cell = 0; cell < board.cells(); cell++) {
      for (int next : board.neighbours(cell)) {
        if (next > cell && rng.nextBoolean(REMOVED)) {
          board.setLinked(cell, next, true);
        }
      }
    }
    int closed = rng.nextInt(board.cells());
    board.neighbours(closed).forEach(next -> board.setLinked(closed, next, false));
    return board;
  }

  private static void joinAll(Board board, Rng rng) {
    BitSet joined = new BitSet();
    ArrayDeque<Integer> walk = new ArrayDeque<>(List.of(0));
    joined.set(0);
    while (!walk.isEmpty()) {
      int cell = walk.element();
      List<Integer> choice = new ArrayList<>(board.neighbours(cell));
      choice.removeIf(joined::get);
      if (choice.isEmpty()) {
        walk.pop();
      } else {
        int next = choice.get(rng.nextInt(choice.size()));
        board.setLinked(cell, next, true);
        joined.set(next);
        walk.push(next);
      }
    }
  }

  private static Obstacles walls(Board board, double hidden, Rng rng) {
    List<Point> border = new ArrayList<>(board.floor().outline().vertices());
    border.add(border.get(0));
    List<Obstacle> walls = new ArrayList<>();
    walls.add(Obstacle.wall(border.toArray(new Point[0])));
    for (int column = 1; column < board.columns(); column++) {
      addLine(walls, board, true, column, hidden, rng);
    }
    for (int row = 1; row < board.rows(); row++) {
      addLine(walls, board, false, row, hidden, rng);
    }
    return new Obstacles(walls);
  }

  /** Adds the walls on one line: above a row of cells, or, upright, to the right of a column. */
  private static void addLine(
      List<Obstacle> walls, Board board, boolean isUpright, int line, double hidden, Rng rng) {
    int across = isUpright ? 1 : board.columns();
    int along = isUpright ? board.columns() : 1;
    int count = isUpright ? board.rows() : board.columns();
    int from = 0;
    for (int to = 0; to <= count; to++) {
      int cell = (line - 1) * across + to * along;
      boolean isWall = to < count && !board.isLinked(cell, cell + across);
      if (to > from && (!isWall || to - from == LONGEST_WALL)) {
        List<Point> ends = List.of(corner(isUpright, line, from), corner(isUpright, line, to));
        walls.add(new Obstacle(ends, false, rng.nextBoolean(hidden), Obstacle.FOREVER));
        from = to;
      }
      if (!isWall) {
        from = to + 1;
      }
    }
  }

  private static Point corner(boolean isUpright, int line, int along) {
    Point corner = isUpright ? new Point(line, along) : new Point(along, line);
    return corner.times(CELL_MM);
  }
}
