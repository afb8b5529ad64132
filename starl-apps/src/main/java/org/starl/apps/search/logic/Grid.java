package org.starl.apps.search.logic;

import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** Square cells over a floor, numbered row by row from the lower left corner. Immutable. */
public final class Grid {

  private static final int MAX_CELLS = 4_000_000;

  private final double xMinMm;
  private final double yMinMm;
  private final int cellMm;
  private final int columns;
  private final int rows;

  /**
   * @param cellMm side of a cell, above 0
   */
  public Grid(Rectangle bounds, int cellMm) {
    xMinMm = bounds.xMinMm();
    yMinMm = bounds.yMinMm();
    this.cellMm = cellMm;
    double across = Math.max(1, StrictMath.ceil((bounds.xMaxMm() - xMinMm) / cellMm));
    double up = Math.max(1, StrictMath.ceil((bounds.yMaxMm() - yMinMm) / cellMm));
    if (cellMm <= 0 || across * up > MAX_CELLS) {
      throw new IllegalArgumentException(
          "cells of " + cellMm + " mm on " + bounds + ": expected above 0, and at most 4 million");
    }
    columns = (int) across;
    rows = (int) up;
  }

  public int cellMm() {
    return cellMm;
  }

  public int columns() {
    return columns;
  }

  public int rows() {
    return rows;
  }

  public int count() {
    return columns * rows;
  }

  /** The column in which {@code xMm} lies; outside the floor one that is not there. */
  int column(double xMm) {
    return (int) StrictMath.floor((xMm - xMinMm) / cellMm);
  }

  int row(double yMm) {
    return (int) StrictMath.floor((yMm - yMinMm) / cellMm);
  }

  boolean isOn(int column, int row) {
    return column >= 0 && column < columns && row >= 0 && row < rows;
  }

  int cell(int column, int row) {
    return row * columns + column;
  }

  /** The cell in which a point lies; -1 off the floor. */
  public int cellAt(Point point) {
    int column = column(point.xMm());
    int row = row(point.yMm());
    return isOn(column, row) ? cell(column, row) : -1;
  }

  public double centreX(int cell) {
    return xMinMm + (cell % columns + 0.5) * cellMm;
  }

  public double centreY(int cell) {
    int row = cell / columns;
    return yMinMm + (row + 0.5) * cellMm;
  }

  public Point centre(int cell) {
    return new Point(centreX(cell), centreY(cell));
  }

  /** Calls {@code visitor} for each cell whose centre is within {@code rangeMm} of a point, in order. */
  public void forEachWithin(Point middle, double rangeMm, Visitor visitor) {
    int fromColumn = Math.max(0, column(middle.xMm() - rangeMm));
    int toColumn = Math.min(columns - 1, column(middle.xMm() + rangeMm));
    int fromRow = Math.max(0, row(middle.yMm() - rangeMm));
    int toRow = Math.min(rows - 1, row(middle.yMm() + rangeMm));
    for (int row = fromRow; row <= toRow; row++) {
      for (int column = fromColumn; column <= toColumn; column++) {
        int cell = cell(column, row);
        double dx = centreX(cell) - middle.xMm();
        double dy = centreY(cell) - middle.yMm();
        if (dx * dx + dy * dy <= rangeMm * rangeMm) {
          visitor.visit(cell);
        }
      }
    }
  }

  /** The neighbour of a cell to the right (0), above (1), left (2) or below (3); -1 at the border. */
  int neighbour(int cell, int side) {
    int column = cell % columns + (side == 0 ? 1 : side == 2 ? -1 : 0);
    int row = cell / columns + (side == 1 ? 1 : side == 3 ? -1 : 0);
    return isOn(column, row) ? cell(column, row) : -1;
  }

  /** Takes a cell. */
  @FunctionalInterface
  public interface Visitor {
    void visit(int cell);
  }
}
