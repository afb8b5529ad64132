package org.starl.apps.search.logic;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** Square cells over a floor, numbered row by row from the lower left corner. Immutable. */
public final class Grid {

  private static final int MAX_CELLS = 4_000_000;

  private final Rectangle bounds;
  private final int cellMm;
  private final int columns;
  private final int rows;

  /**
   * @param cellMm side of a cell, above 0
   */
  Grid(Rectangle bounds, int cellMm) {
    this.bounds = bounds;
    this.cellMm = cellMm;
    double across = StrictMath.ceil((bounds.xMaxMm() - bounds.xMinMm()) / cellMm);
    double up = StrictMath.ceil((bounds.yMaxMm() - bounds.yMinMm()) / cellMm);
    if (cellMm <= 0 || across * up > MAX_CELLS) {
      throw new IllegalArgumentException(
          "cells of " + cellMm + " mm on " + bounds + ": expected above 0, and at most 4 million");
    }
    columns = (int) Math.max(1, across);
    rows = (int) Math.max(1, up);
  }

  public int cellMm() {
    return cellMm;
  }

  public int columns() {
    return columns;
  }

  int rows() {
    return rows;
  }

  int count() {
    return columns * rows;
  }

  int cell(int column, int row) {
    return row * columns + column;
  }

  /** The cell in which a point lies; -1 off the floor. */
  public int cellAt(Point point) {
    int column = column(point.xMm());
    int row = row(point.yMm());
    boolean isOnFloor = column >= 0 && column < columns && row >= 0 && row < rows;
    return isOnFloor ? cell(column, row) : -1;
  }

  public Point centre(int cell) {
    int row = cell / columns;
    return new Point(centreX(cell), bounds.yMinMm() + (row + 0.5) * cellMm);
  }

  private double centreX(int cell) {
    return bounds.xMinMm() + (cell % columns + 0.5) * cellMm;
  }

  /** The cells whose centres are within {@code rangeMm} of a point, in order. */
  public IntStream within(Point middle, double rangeMm) {
    return in(Rectangle.around(middle, 2 * rangeMm, 2 * rangeMm))
        .filter(cell -> {
          Point centre = centre(cell);
          double dx = centre.xMm() - middle.xMm();
          double dy = centre.yMm() - middle.yMm();
          return dx * dx + dy * dy <= rangeMm * rangeMm;
        });
  }

  /** The cells that have a point in common with a rectangle, in order. */
  IntStream in(Rectangle box) {
    int fromColumn = Math.max(0, column(box.xMinMm()));
    int toColumn = Math.min(columns - 1, column(box.xMaxMm()));
    int fromRow = Math.max(0, row(box.yMinMm()));
    int toRow = Math.min(rows - 1, row(box.yMaxMm()));
    return IntStream.rangeClosed(fromRow, toRow)
        .flatMap(
            row -> IntStream.rangeClosed(fromColumn, toColumn).map(column -> cell(column, row)));
  }

  /** Whether one may go from a cell to its neighbour. */
  interface Step {
    boolean isOpen(int cell, int neighbour);
  }

  /**
   * How many steps it is from the nearest of some cells to each cell; -1 where no way leads.
   * Breadth-first search; each cell has up to four neighbours.
   */
  int[] steps(BitSet from, Step step) {
    int[] steps = new int[count()];
    Arrays.fill(steps, -1);
    int[] queue = new int[count()];
    int tail = 0;
    for (int cell = from.nextSetBit(0); cell >= 0; cell = from.nextSetBit(cell + 1)) {
      steps[cell] = 0;
      queue[tail++] = cell;
    }
    for (int head = 0; head < tail; head++) {
      int cell = queue[head];
      int column = cell % columns;
      int[] neighbours = {
        column + 1 < columns ? cell + 1 : -1,
        cell + columns < steps.length ? cell + columns : -1,
        column > 0 ? cell - 1 : -1,
        cell - columns
      };
      for (int next : neighbours) {
        if (next >= 0 && steps[next] < 0 && step.isOpen(cell, next)) {
          steps[next] = steps[cell] + 1;
          queue[tail++] = next;
        }
      }
    }
    return steps;
  }

  /** All cells to which a way leads from one of {@code from}. */
  BitSet reached(BitSet from, Step step) {
    int[] steps = steps(from, step);
    BitSet reached = new BitSet();
    for (int cell = 0; cell < steps.length; cell++) {
      reached.set(cell, steps[cell] >= 0);
    }
    return reached;
  }

  private int column(double xMm) {
    return (int) StrictMath.floor((xMm - bounds.xMinMm()) / cellMm);
  }

  private int row(double yMm) {
    return (int) StrictMath.floor((yMm - bounds.yMinMm()) / cellMm);
  }
}
