package org.starl.sim.world;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;

/**
 * A floor of square cells, each free or blocked. Columns go to the right from 0, rows <em>up</em>
 * from 0: the last row of a file is row 0. Immutable.
 */
public final class GridMap {

  private final int columns;
  private final int rows;
  private final BitSet blocked;

  /**
   * @param blocked cell (column, row) is bit {@code row * columns + column}
   */
  public GridMap(int columns, int rows, BitSet blocked) {
    this.columns = columns;
    this.rows = rows;
    this.blocked = (BitSet) blocked.clone();
  }

  public int columns() {
    return columns;
  }

  public int rows() {
    return rows;
  }

  /** Whether a cell is free; cells outside the map are not. */
  public boolean isFree(int column, int row) {
    boolean isInside = column >= 0 && column < columns && row >= 0 && row < rows;
    return isInside && !blocked.get(row * columns + column);
  }

  public int freeCells() {
    return columns * rows - blocked.cardinality();
  }

  /**
   * The blocked cells as known solid rectangles: runs of cells in a row are merged with equal runs
   * of the rows above.
   *
   * @param cellMm the side of a cell
   */
  public Obstacles walls(double cellMm) {
    List<Obstacle> walls = new ArrayList<>();
    BitSet left = (BitSet) blocked.clone();
    for (int cell = left.nextSetBit(0); cell >= 0; cell = left.nextSetBit(cell + 1)) {
      int row = cell / columns;
      int column = cell % columns;
      int end = column + 1;
      while (end < columns && left.get(row * columns + end)) {
        end++;
      }
      int top = row + 1;
      while (top < rows && isRun(left, column, end, top)) {
        top++;
      }
      for (int i = row; i < top; i++) {
        left.clear(i * columns + column, i * columns + end);
      }
      walls.add(box(column * cellMm, row * cellMm, end * cellMm, top * cellMm));
    }
    return new Obstacles(walls);
  }

  private boolean isRun(BitSet cells, int column, int end, int row) {
    int from = row * columns;
    return cells.nextClearBit(from + column) >= from + end;
  }

  private static Obstacle box(double xMin, double yMin, double xMax, double yMax) {
    return Obstacle.body(
        new Point(xMin, yMin), new Point(xMax, yMin), new Point(xMax, yMax), new Point(xMin, yMax));
  }
}
