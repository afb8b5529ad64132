package org.starl.primitives.paths;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/** A breadth-first search on a grid, independent of the planners. */
final class GridOracle {

  private static final double MESH_MM = 50;

  private final PlanTask task;
  private final double marginMm;
  private final int columns;
  private final int rows;
  private final int[] steps;

  /**
   * @param marginMm the least distance from the path to any obstacle
   */
  GridOracle(PlanTask task, double marginMm) {
    this.task = task;
    this.marginMm = marginMm;
    columns = (int) (task.bounds().xMaxMm() / MESH_MM) + 1;
    rows = (int) (task.bounds().yMaxMm() / MESH_MM) + 1;
    steps = new int[columns * rows];
  }

  /** The length of a path, or infinite if the search finds none. */
  double lengthMm() {
    Arrays.fill(steps, -1);
    Deque<Integer> open = new ArrayDeque<>();
    int start = nearest(task.start());
    int goal = nearest(task.goal());
    if (!isOpen(task.start(), point(start)) || !isOpen(point(goal), task.goal())) {
      return Double.POSITIVE_INFINITY;
    }
    steps[start] = 0;
    open.add(start);
    while (!open.isEmpty()) {
      int node = open.remove();
      visit(node, node % columns > 0, node - 1, open);
      visit(node, node % columns < columns - 1, node + 1, open);
      visit(node, node >= columns, node - columns, open);
      visit(node, node < columns * (rows - 1), node + columns, open);
    }
    return steps[goal] < 0
        ? Double.POSITIVE_INFINITY
        : steps[goal] * MESH_MM
            + task.start().distanceMm(point(start))
            + task.goal().distanceMm(point(goal));
  }

  private void visit(int from, boolean exists, int to, Deque<Integer> open) {
    if (exists && steps[to] < 0 && isOpen(point(from), point(to))) {
      steps[to] = steps[from] + 1;
      open.add(to);
    }
  }

  private boolean isOpen(Point from, Point to) {
    return Floors.clearanceMm(new Segment(from, to), task) >= marginMm;
  }

  private int nearest(Point point) {
    int column = (int) StrictMath.round(point.xMm() / MESH_MM);
    int row = (int) StrictMath.round(point.yMm() / MESH_MM);
    return Math.min(column, columns - 1) + columns * Math.min(row, rows - 1);
  }

  private Point point(int node) {
    return new Point(node % columns * MESH_MM, node / columns * MESH_MM);
  }
}
