package org.starl.motion;

import java.util.Arrays;

/**
 * The last wheel commands, oldest first, each with the state of {@link Odometry} at its time. They
 * are stored in columns, from the start of the arrays: a robot gives several commands a second, and
 * with thousands of robots each object of a command would be out of the processor's cache.
 */
final class CommandLog {

  private static final int LEAST_COMMANDS = 4;

  // The columns of a command.
  private static final int LINEAR = 0;
  private static final int ANGULAR = 1;
  private static final int TOUCHING = 2;
  private static final int X = 3;
  private static final int Y = 4;
  private static final int HEADING = 5;
  private static final int PATH = 6;
  private static final int STRAY = 7;
  private static final int TURNED = 8;
  private static final int COLUMNS = 9;

  // A body that has always been at rest; of all logs without a command, and never written.
  private static final long[] REST_NS = {Long.MIN_VALUE};
  private static final double[] REST = new double[COLUMNS];

  private long[] atNs = REST_NS;
  private double[] cells = REST;
  private int size = 1;

  int size() {
    return size;
  }

  /** Adds a command, whose state must be set next. */
  void add(long nowNs, double linear, double angular, boolean isTouching) {
    if (size == atNs.length) {
      int room = Math.max(LEAST_COMMANDS, 2 * size);
      atNs = Arrays.copyOf(atNs, room);
      cells = Arrays.copyOf(cells, room * COLUMNS);
    }
    atNs[size] = nowNs;
    int row = size * COLUMNS;
    cells[row + LINEAR] = linear;
    cells[row + ANGULAR] = angular;
    cells[row + TOUCHING] = isTouching ? 1 : 0;
    size++;
  }

  /** Sets the state at the time of the newest command. */
  void setState(double x, double y, double heading, double path, double stray, double turned) {
    int row = (size - 1) * COLUMNS;
    cells[row + X] = x;
    cells[row + Y] = y;
    cells[row + HEADING] = heading;
    cells[row + PATH] = path;
    cells[row + STRAY] = stray;
    cells[row + TURNED] = turned;
  }

  /** Forgets the {@code count} oldest commands, which must not be all. */
  void forget(int count) {
    if (count > 0) {
      size -= count;
      System.arraycopy(atNs, count, atNs, 0, size);
      System.arraycopy(cells, count * COLUMNS, cells, 0, size * COLUMNS);
    }
  }

  /** The newest command that was given by {@code timeNs}, or the oldest one. */
  int indexAt(long timeNs) {
    int index = size - 1;
    while (index > 0 && atNs[index] > timeNs) {
      index--;
    }
    return index;
  }

  long atNs(int index) {
    return atNs[index];
  }

  double linear(int index) {
    return cells[index * COLUMNS + LINEAR];
  }

  double angular(int index) {
    return cells[index * COLUMNS + ANGULAR];
  }

  /** Whether a bump sensor was closed. */
  boolean isTouching(int index) {
    return cells[index * COLUMNS + TOUCHING] != 0;
  }

  double x(int index) {
    return cells[index * COLUMNS + X];
  }

  double y(int index) {
    return cells[index * COLUMNS + Y];
  }

  double heading(int index) {
    return cells[index * COLUMNS + HEADING];
  }

  double path(int index) {
    return cells[index * COLUMNS + PATH];
  }

  double stray(int index) {
    return cells[index * COLUMNS + STRAY];
  }

  double turned(int index) {
    return cells[index * COLUMNS + TURNED];
  }
}
