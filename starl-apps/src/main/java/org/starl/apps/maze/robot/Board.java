package org.starl.apps.maze.robot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * A graph of the true floor, hidden obstacles included: its nodes are square cells, its links join
 * neighbours without a wall between them. A body that fits a cell with its margin gets from the
 * middle of a cell to the middle of another exactly if links lead there. A cell is its number, row
 * by row from the lower left.
 *
 * @param free the cells without an obstacle
 * @param right the cells that are linked with that to their right
 * @param up the cells that are linked with that above
 */
public record Board(int columns, int rows, double cellMm, BitSet free, BitSet right, BitSet up) {

  /** A board without links. */
  Board(int columns, int rows, double cellMm, IntPredicate isFree) {
    this(columns, rows, cellMm, new BitSet(), new BitSet(), new BitSet());
    for (int cell = 0; cell < cells(); cell++) {
      free.set(cell, isFree.test(cell));
    }
  }

  /** A board on which all free neighbours are linked. */
  public static Board open(int columns, int rows, double cellMm, IntPredicate isFree) {
    Board board = new Board(columns, rows, cellMm, isFree);
    BitSet free = board.free;
    for (int cell = free.nextSetBit(0); cell >= 0; cell = free.nextSetBit(cell + 1)) {
      board.right.set(cell, (cell + 1) % columns != 0 && free.get(cell + 1));
      board.up.set(cell, free.get(cell + columns));
    }
    return board;
  }

  int cells() {
    return columns * rows;
  }

  public Rectangle floor() {
    return new Rectangle(0, 0, columns * cellMm, rows * cellMm);
  }

  public Point middle(int cell) {
    int row = cell / columns;
    return new Point((cell % columns + 0.5) * cellMm, (row + 0.5) * cellMm);
  }

  /** The cells beside a cell, free or not, linked or not. */
  List<Integer> neighbours(int cell) {
    return IntStream.of(cell - 1, cell + 1, cell - columns, cell + columns)
        .filter(next -> next >= 0 && next < cells())
        .filter(next -> next % columns == cell % columns || next / columns == cell / columns)
        .boxed()
        .collect(Collectors.toList());
  }

  boolean isLinked(int cell, int neighbour) {
    return links(cell, neighbour).get(Math.min(cell, neighbour));
  }

  void setLinked(int cell, int neighbour, boolean isLinked) {
    links(cell, neighbour).set(Math.min(cell, neighbour), isLinked);
  }

  private BitSet links(int cell, int neighbour) {
    return Math.abs(cell - neighbour) == 1 ? right : up;
  }

  /**
   * Number of steps from a cell to each cell, or -1 if there is no way.
   *
   * @param avoided cells that the way may not enter
   * @param to cells that are not nearer than this one may be left out; -1 for all cells
   */
  int[] steps(int from, BitSet avoided, int to) {
    int[] steps = new int[cells()];
    Arrays.fill(steps, -1);
    int[] reached = new int[cells()];
    int count = 1;
    reached[0] = from;
    steps[from] = 0;
    for (int i = 0; i < count && reached[i] != to; i++) {
      int cell = reached[i];
      for (int beside = 0; beside < 4; beside++) {
        int step = beside < 2 ? 1 : columns;
        int next = cell + (beside % 2 == 0 ? -step : step);
        if (next >= 0
            && next < steps.length
            && steps[next] < 0
            && isLinked(cell, next)
            && !avoided.get(next)) {
          steps[next] = steps[cell] + 1;
          reached[count++] = next;
        }
      }
    }
    return steps;
  }

  /** The cells on a shortest way between two cells, both included; empty if there is none. */
  List<Integer> way(int from, int to, BitSet avoided) {
    int[] steps = steps(to, avoided, from);
    List<Integer> way = new ArrayList<>();
    int cell = from;
    for (int left = steps[from]; left >= 0; left--) {
      way.add(cell);
      for (int next : neighbours(cell)) {
        if (isLinked(cell, next) && steps[next] == left - 1) {
          cell = next;
          break;
        }
      }
    }
    return way;
  }
}
