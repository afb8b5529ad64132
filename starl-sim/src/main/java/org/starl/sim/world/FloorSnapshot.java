package org.starl.sim.world;

import java.util.Arrays;
import java.util.List;

/**
 * The positions of all bodies at one time, in arrays ordered by the cells of a grid, row by row: a
 * search reads memory in order, and nothing of the bodies themselves. Taking one costs time linear in
 * the number of bodies.
 */
final class FloorSnapshot {

  private static final double LEAST_CELL_MM = 1000;
  private static final int MOST_CELLS_A_BODY = 4;

  private double cellMm;
  private double leastX;
  private double leastY;
  private int columns;
  private int rows;
  // The index of the first body of each cell, and at last the number of bodies.
  private int[] starts = {0, 0};
  private int[] cells = {};
  private double[] x = {};
  private double[] y = {};
  private double[] radiusMm = {};
  private int[] numbers = {};

  void take(List<Body> bodies, long nowNs) {
    int size = bodies.size();
    if (x.length < size) {
      cells = new int[2 * size];
      x = new double[2 * size];
      y = new double[2 * size];
      radiusMm = new double[2 * size];
      numbers = new int[2 * size];
    }
    layOut(bodies, nowNs);
    for (int i = 0; i < size; i++) {
      Body body = bodies.get(i);
      cells[i] = row(body.yMm()) * columns + column(body.xMm());
      starts[cells[i] + 1]++;
    }
    for (int cell = 0; cell < columns * rows; cell++) {
      starts[cell + 1] += starts[cell];
    }
    // Backwards, so that each start ends where its cell begins.
    for (int i = size - 1; i >= 0; i--) {
      Body body = bodies.get(i);
      int at = --starts[cells[i] + 1];
      x[at] = body.xMm();
      y[at] = body.yMm();
      radiusMm[at] = body.radiusMm();
      numbers[at] = body.number();
    }
    System.arraycopy(starts, 1, starts, 0, columns * rows);
    starts[columns * rows] = size;
  }

  private void layOut(List<Body> bodies, long nowNs) {
    leastX = Double.POSITIVE_INFINITY;
    leastY = Double.POSITIVE_INFINITY;
    double mostX = Double.NEGATIVE_INFINITY;
    double mostY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < bodies.size(); i++) {
      Body body = bodies.get(i);
      body.moveTo(nowNs);
      leastX = Math.min(leastX, body.xMm());
      leastY = Math.min(leastY, body.yMm());
      mostX = Math.max(mostX, body.xMm());
      mostY = Math.max(mostY, body.yMm());
    }
    double mostCells = (double) MOST_CELLS_A_BODY * bodies.size() + 1;
    cellMm = LEAST_CELL_MM;
    while (((mostX - leastX) / cellMm + 1) * ((mostY - leastY) / cellMm + 1) > mostCells) {
      cellMm *= 2;
    }
    columns = (int) ((mostX - leastX) / cellMm) + 1;
    rows = (int) ((mostY - leastY) / cellMm) + 1;
    if (starts.length < columns * rows + 2) {
      starts = new int[2 * columns * rows + 2];
    }
    Arrays.fill(starts, 0, columns * rows + 2, 0);
  }

  /** Passes all bodies within {@code rangeMm} of a point, and some others, to {@code near}. */
  void find(double atX, double atY, double rangeMm, Surroundings near) {
    int firstColumn = column(atX - rangeMm);
    int lastColumn = column(atX + rangeMm);
    int lastRow = row(atY + rangeMm);
    for (int row = row(atY - rangeMm); row <= lastRow; row++) {
      int end = starts[row * columns + lastColumn + 1];
      for (int i = starts[row * columns + firstColumn]; i < end; i++) {
        near.add(x[i], y[i], radiusMm[i], numbers[i]);
      }
    }
  }

  private int column(double atX) {
    return clamped((atX - leastX) / cellMm, columns);
  }

  private int row(double atY) {
    return clamped((atY - leastY) / cellMm, rows);
  }

  private static int clamped(double index, int size) {
    return Math.max(0, Math.min(size - 1, (int) index));
  }
}
