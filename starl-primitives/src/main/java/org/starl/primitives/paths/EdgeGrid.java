package org.starl.primitives.paths;

import java.util.Arrays;

/**
 * Finds the edges near a segment, with a grid of square cells that list the edges through them.
 * Finds every edge that has a point in common with the segment, and some others.
 */
final class EdgeGrid {

  private static final int NONE = -1;
  private static final int MAX_CELLS_PER_SIDE = 1024;

  private final int xMin;
  private final int yMin;
  private final int cellMm;
  private final int columns;
  private final int rows;

  /**
   * Linked lists of edges, one per cell: the first entry; then each entry's edge and next entry.
   */
  private final int[] head;

  private int[] edgeOf;
  private int[] after;
  private int entries;

  /** The query in which an edge was last found. */
  private final int[] foundIn;

  private int query;

  // The state of the current query.
  private double lineX;
  private double lineY;
  private double slope;
  private int lastRow;
  private int row;
  private int column;
  private int lastColumn;
  private int entry;
  private double lowX;
  private double highX;

  EdgeGrid(int[] x, int[] y, int[] next) {
    int edges = x.length;
    xMin = Arrays.stream(x).min().orElse(0);
    yMin = Arrays.stream(y).min().orElse(0);
    int width = Arrays.stream(x).max().orElse(0) - xMin + 1;
    int height = Arrays.stream(y).max().orElse(0) - yMin + 1;
    double wanted = StrictMath.sqrt((double) width * height / Math.max(1, edges));
    double least = (double) Math.max(width, height) / MAX_CELLS_PER_SIDE;
    cellMm = (int) Math.max(1, StrictMath.ceil(Math.max(wanted, least)));
    columns = width / cellMm + 1;
    rows = height / cellMm + 1;
    head = new int[columns * rows];
    Arrays.fill(head, NONE);
    edgeOf = new int[4 * edges + 16];
    after = new int[4 * edges + 16];
    foundIn = new int[edges];
    for (int edge = 0; edge < edges; edge++) {
      insert(edge, x[edge], y[edge], x[next[edge]], y[next[edge]]);
    }
  }

  /** Begins a query for the edges near a segment. */
  void begin(int px, int py, int qx, int qy) {
    query++;
    aim(px, py, qx, qy);
  }

  /**
   * Begins a query for the edges near the horizontal segment from the left border to a point, given
   * by twice its coordinates.
   */
  void beginLeftOf(long x2, long y2) {
    query++;
    double y = y2 / 2.0;
    lineX = x2 / 2.0;
    lineY = y;
    slope = 0;
    lowX = xMin;
    highX = lineX;
    row = rowOf(y - 1);
    lastRow = rowOf(y + 1);
    enterRow();
  }

  /** The next edge of the query, or -1; no edge comes twice. */
  int nextEdge() {
    while (true) {
      while (entry != NONE) {
        int edge = edgeOf[entry];
        entry = after[entry];
        if (foundIn[edge] != query) {
          foundIn[edge] = query;
          return edge;
        }
      }
      if (!enterNextCell()) {
        return NONE;
      }
    }
  }

  private void insert(int edge, int px, int py, int qx, int qy) {
    aim(px, py, qx, qy);
    do {
      int cell = row * columns + column;
      if (entries == edgeOf.length) {
        edgeOf = Arrays.copyOf(edgeOf, 2 * entries);
        after = Arrays.copyOf(after, 2 * entries);
      }
      edgeOf[entries] = edge;
      after[entries] = head[cell];
      head[cell] = entries;
      entries++;
      entry = NONE;
    } while (enterNextCell());
  }

  private void aim(int px, int py, int qx, int qy) {
    lineX = px;
    lineY = py;
    slope = py == qy ? 0 : ((double) qx - px) / ((double) qy - py);
    lowX = Math.min(px, qx);
    highX = Math.max(px, qx);
    row = rowOf(Math.min(py, qy));
    lastRow = rowOf(Math.max(py, qy));
    enterRow();
  }

  private void enterRow() {
    double low = lowX;
    double high = highX;
    if (slope != 0) {
      double atBottom = lineX + (yMin + (double) row * cellMm - lineY) * slope;
      double atTop = lineX + (yMin + (row + 1.0) * cellMm - lineY) * slope;
      low = Math.max(low, Math.min(atBottom, atTop));
      high = Math.min(high, Math.max(atBottom, atTop));
    }
    // One mm more on either side covers rounding.
    column = columnOf(low - 1);
    lastColumn = columnOf(high + 1);
    entry = head[row * columns + column];
  }

  private boolean enterNextCell() {
    if (column < lastColumn) {
      column++;
      entry = head[row * columns + column];
      return true;
    }
    if (row < lastRow) {
      row++;
      enterRow();
      return true;
    }
    return false;
  }

  private int columnOf(double mm) {
    return clamp((mm - xMin) / cellMm, columns);
  }

  private int rowOf(double mm) {
    return clamp((mm - yMin) / cellMm, rows);
  }

  private static int clamp(double cell, int count) {
    return (int) Math.max(0, Math.min(count - 1.0, StrictMath.floor(cell)));
  }
}
