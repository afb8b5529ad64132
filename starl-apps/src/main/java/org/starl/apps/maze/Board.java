package org.starl.apps.maze;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * The true floor in square cells: which cells are free, and between which neighbours there is a wall,
 * hidden obstacles included. A body that fits a cell with its margin gets from the middle of a cell to
 * the middle of another exactly if free neighbours lead there. A cell is its number, row by row from
 * the lower left.
 */
final class Board {

  private final int columns;
  private final int rows;
  private final double cellMm;
  private final BitSet blocked = new BitSet();
  // For each cell: whether there is a wall on its right side, and on its upper side.
  private final BitSet wallRight = new BitSet();
  private final BitSet wallAbove = new BitSet();

  Board(int columns, int rows, double cellMm) {
    this.columns = columns;
    this.rows = rows;
    this.cellMm = cellMm;
  }

  int columns() {
    return columns;
  }

  int rows() {
    return rows;
  }

  double cellMm() {
    return cellMm;
  }

  int cells() {
    return columns * rows;
  }

  Rectangle floor() {
    return new Rectangle(0, 0, columns * cellMm, rows * cellMm);
  }

  Point middle(int cell) {
    int column = cell % columns;
    int row = cell / columns;
    return new Point((column + 0.5) * cellMm, (row + 0.5) * cellMm);
  }

  boolean isFree(int cell) {
    return !blocked.get(cell);
  }

  void setFree(int cell, boolean isFree) {
    blocked.set(cell, !isFree);
  }

  /** Whether there is a wall between two neighbours. */
  boolean hasWall(int cell, int neighbour) {
    return walls(cell, neighbour).get(Math.min(cell, neighbour));
  }

  void setWall(int cell, int neighbour, boolean stands) {
    walls(cell, neighbour).set(Math.min(cell, neighbour), stands);
  }

  private BitSet walls(int cell, int neighbour) {
    return Math.abs(cell - neighbour) == 1 && cell / columns == neighbour / columns
        ? wallRight
        : wallAbove;
  }

  /** The cells beside a cell, free or not, whatever wall is between. */
  List<Integer> neighbours(int cell) {
    List<Integer> neighbours = new ArrayList<>(4);
    if (cell % columns > 0) {
      neighbours.add(cell - 1);
    }
    if (cell % columns < columns - 1) {
      neighbours.add(cell + 1);
    }
    if (cell >= columns) {
      neighbours.add(cell - columns);
    }
    if (cell < columns * (rows - 1)) {
      neighbours.add(cell + columns);
    }
    return neighbours;
  }

  /**
   * Number of steps from a cell to each cell, or -1 if there is no way.
   *
   * @param avoided cells that the way may not enter
   */
  int[] steps(int from, BitSet avoided) {
    int[] steps = new int[cells()];
    Arrays.fill(steps, -1);
    ArrayDeque<Integer> open = new ArrayDeque<>();
    steps[from] = 0;
    open.add(from);
    while (!open.isEmpty()) {
      int cell = open.remove();
      for (int next : neighbours(cell)) {
        boolean isOpen = steps[next] < 0 && isFree(next) && !avoided.get(next);
        if (isOpen && !hasWall(cell, next)) {
          steps[next] = steps[cell] + 1;
          open.add(next);
        }
      }
    }
    return steps;
  }

  /** The cells on a shortest way between two cells, both included; empty if there is none. */
  List<Integer> way(int from, int to, BitSet avoided) {
    int[] steps = steps(to, avoided);
    List<Integer> way = new ArrayList<>();
    if (steps[from] < 0) {
      return way;
    }
    int cell = from;
    way.add(cell);
    while (cell != to) {
      for (int next : neighbours(cell)) {
        if (steps[next] == steps[cell] - 1 && !hasWall(cell, next)) {
          cell = next;
          break;
        }
      }
      way.add(cell);
    }
    return way;
  }
}
