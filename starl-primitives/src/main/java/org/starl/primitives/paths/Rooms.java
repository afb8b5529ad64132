package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;

/**
 * The rooms of a free space: the holes in the solid area. No path connects points in different
 * rooms, except along a line without width. This answer saves a search through all reachable
 * corners.
 */
final class Rooms {

  static final int NONE = -1;

  private final List<int[][]> holes = new ArrayList<>();
  private final List<int[]> boxes = new ArrayList<>();
  private final List<Double> areas = new ArrayList<>();

  /**
   * @param rings x and y of their corners, the solid side on the left: holes run clockwise
   */
  Rooms(List<int[][]> rings) {
    for (int[][] ring : rings) {
      double area = area(ring);
      if (area < 0) {
        holes.add(ring);
        boxes.add(box(ring));
        areas.add(-area);
      }
    }
  }

  /** The smallest hole that contains a point, its border included. */
  int at(int px, int py) {
    int best = NONE;
    for (int i = 0; i < holes.size(); i++) {
      int[] box = boxes.get(i);
      boolean isNear = box[0] <= px && px <= box[2] && box[1] <= py && py <= box[3];
      boolean isLess = best == NONE || areas.get(i) < areas.get(best);
      if (isNear && isLess && contains(holes.get(i), px, py)) {
        best = i;
      }
    }
    return best;
  }

  int xMin(int room) {
    return boxes.get(room)[0];
  }

  int yMin(int room) {
    return boxes.get(room)[1];
  }

  int xMax(int room) {
    return boxes.get(room)[2];
  }

  int yMax(int room) {
    return boxes.get(room)[3];
  }

  private static double area(int[][] ring) {
    double twice = 0;
    int count = ring[0].length;
    for (int i = 0; i < count; i++) {
      int j = (i + 1) % count;
      twice += (double) ring[0][i] * ring[1][j] - (double) ring[0][j] * ring[1][i];
    }
    return twice / 2;
  }

  private static int[] box(int[][] ring) {
    int[] box = {ring[0][0], ring[1][0], ring[0][0], ring[1][0]};
    for (int i = 1; i < ring[0].length; i++) {
      box[0] = Math.min(box[0], ring[0][i]);
      box[1] = Math.min(box[1], ring[1][i]);
      box[2] = Math.max(box[2], ring[0][i]);
      box[3] = Math.max(box[3], ring[1][i]);
    }
    return box;
  }

  private static boolean contains(int[][] ring, int px, int py) {
    int[] x = ring[0];
    int[] y = ring[1];
    boolean inside = false;
    int j = x.length - 1;
    for (int i = 0; i < x.length; i++) {
      long side =
          ((long) x[i] - x[j]) * ((long) py - y[j]) - ((long) y[i] - y[j]) * ((long) px - x[j]);
      if (side == 0 && FreeSpace.isBetween(px, py, x[i], y[i], x[j], y[j])) {
        return true;
      }
      if ((y[j] > py) != (y[i] > py) && (side > 0) == (y[i] > y[j])) {
        inside = !inside;
      }
      j = i;
    }
    return inside;
  }
}
