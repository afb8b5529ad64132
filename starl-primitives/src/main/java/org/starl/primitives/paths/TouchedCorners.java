package org.starl.primitives.paths;

import java.util.Arrays;

/** The corners on a segment, in order along it, between the segment's two ends. */
final class TouchedCorners {

  private int px;
  private int py;
  private int[] x = new int[8];
  private int[] y = new int[8];
  private int size;

  void begin(int fromX, int fromY) {
    px = fromX;
    py = fromY;
    size = 0;
    append(fromX, fromY);
  }

  /** Inserts a corner in order. */
  void add(int cornerX, int cornerY) {
    append(cornerX, cornerY);
    for (int i = size - 1; i > 1 && fromStart(i - 1) > fromStart(i); i--) {
      swap(x, i);
      swap(y, i);
    }
  }

  void end(int toX, int toY) {
    append(toX, toY);
  }

  int size() {
    return size;
  }

  int x(int i) {
    return x[i];
  }

  int y(int i) {
    return y[i];
  }

  private void append(int newX, int newY) {
    if (size == x.length) {
      x = Arrays.copyOf(x, 2 * size);
      y = Arrays.copyOf(y, 2 * size);
    }
    x[size] = newX;
    y[size] = newY;
    size++;
  }

  private long fromStart(int i) {
    return Math.abs((long) x[i] - px) + Math.abs((long) y[i] - py);
  }

  private static void swap(int[] values, int i) {
    int value = values[i];
    values[i] = values[i - 1];
    values[i - 1] = value;
  }
}
