package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.random.Rng;

/**
 * Maps of the public path-finding benchmarks (Stern and others, "Multi-agent pathfinding", SoCS
 * 2019), with cells of one metre. For a body narrower than a cell, a path exists exactly where free
 * cells with common sides connect the two places.
 */
class MapsTest {

  private static final int CELL_MM = 1000;

  @ParameterizedTest
  @ValueSource(
      strings = {"empty-48-48", "room-32-32-4", "random-64-64-20", "maze-32-32-4", "den312d"})
  void aPathIsFoundExactlyWhereCellsAreConnected(String name) throws IOException {
    boolean[][] free = read(name);
    Obstacles walls = walls(free);
    Rng rng = new Rng(1);
    for (int i = 0; i < 2; i++) {
      int[] start = freeCell(free, rng);
      int[] goal = freeCell(free, rng);
      int cells = cellsBetween(free, start, goal);
      PlanTask task = task(free, walls, start, goal);
      Plan plan = new OptimalPlanner().plan(task);
      if (cells < 0) {
        assertThat(plan).isEqualTo(new Plan.NoPath());
      } else {
        assertThat(plan).isInstanceOf(Plan.Found.class);
        Path path = ((Plan.Found) plan).path();
        assertThat(path.lengthMm()).isLessThanOrEqualTo((double) cells * CELL_MM);
        for (int leg = 0; leg < path.legs(); leg++) {
          assertThat(Floors.clearanceMm(path.leg(leg), task)).isGreaterThanOrEqualTo(400);
        }
      }
    }
  }

  static PlanTask task(boolean[][] free, Obstacles walls, int[] start, int[] goal) {
    Rectangle bounds = new Rectangle(0, 0, free[0].length * CELL_MM, free.length * CELL_MM);
    return new PlanTask(middle(start), middle(goal), bounds, walls, List.of(), 300, 100);
  }

  /** Reads a map; skips the test if the folder, which is not part of the project, is absent. */
  static boolean[][] read(String name) throws IOException {
    String shared = System.getProperty("starl.shared", "../../shared");
    java.nio.file.Path folder = java.nio.file.Path.of(shared).resolve("data/maps");
    assumeTrue(Files.isDirectory(folder), "skipped: no folder " + folder + " (set -Dstarl.shared)");
    List<String> lines = Files.readAllLines(folder.resolve(name + ".map"));
    List<String> cells = lines.subList(lines.indexOf("map") + 1, lines.size());
    boolean[][] free = new boolean[cells.size()][cells.get(0).length()];
    for (int row = 0; row < free.length; row++) {
      for (int column = 0; column < free[row].length; column++) {
        char cell = cells.get(row).charAt(column);
        free[row][column] = cell == '.' || cell == 'G';
      }
    }
    return free;
  }

  /** One body for each run of blocked cells in a row. */
  static Obstacles walls(boolean[][] free) {
    List<Obstacle> walls = new ArrayList<>();
    for (int row = 0; row < free.length; row++) {
      int column = 0;
      while (column < free[row].length) {
        int end = column;
        while (end < free[row].length && !free[row][end]) {
          end++;
        }
        if (end > column) {
          walls.add(block(column, row, end, row + 1));
        }
        column = end + 1;
      }
    }
    return new Obstacles(walls);
  }

  private static Obstacle block(int xMin, int yMin, int xMax, int yMax) {
    return Obstacle.body(
        corner(xMin, yMin), corner(xMax, yMin), corner(xMax, yMax), corner(xMin, yMax));
  }

  private static Point corner(int column, int row) {
    return new Point(column * CELL_MM, row * CELL_MM);
  }

  private static Point middle(int[] cell) {
    return new Point((cell[0] + 0.5) * CELL_MM, (cell[1] + 0.5) * CELL_MM);
  }

  static int[] freeCell(boolean[][] free, Rng rng) {
    while (true) {
      int row = rng.nextInt(free.length);
      int column = rng.nextInt(free[row].length);
      if (free[row][column]) {
        return new int[] {column, row};
      }
    }
  }

  /** The number of steps through common sides, or -1. */
  private static int cellsBetween(boolean[][] free, int[] start, int[] goal) {
    int[][] steps = new int[free.length][free[0].length];
    Deque<int[]> open = new ArrayDeque<>();
    steps[start[1]][start[0]] = 1;
    open.add(start);
    while (!open.isEmpty()) {
      int[] cell = open.remove();
      for (int[] way : new int[][] {{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        int column = cell[0] + way[0];
        int row = cell[1] + way[1];
        boolean inside = row >= 0 && row < free.length && column >= 0 && column < free[0].length;
        if (inside && free[row][column] && steps[row][column] == 0) {
          steps[row][column] = steps[cell[1]][cell[0]] + 1;
          open.add(new int[] {column, row});
        }
      }
    }
    return steps[goal[1]][goal[0]] - 1;
  }
}
