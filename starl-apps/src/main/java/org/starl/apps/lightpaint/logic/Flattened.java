package org.starl.apps.lightpaint.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * Takes out of a polyline the corners that it does not need (Douglas, Peucker, "Algorithms for the
 * reduction of the number of points required to represent a digitized line or its caricature",
 * Cartographica 10(2), 1973), and puts the rest on whole millimetres.
 */
public final class Flattened {

  private Flattened() {}

  /**
   * Points no farther than {@code toleranceMm} and a rounding from the given ones, none twice in a
   * row; fewer than two if the line is nowhere longer than a millimetre.
   */
  public static List<Point> of(List<Point> points, double toleranceMm) {
    List<Point> flat = new ArrayList<>();
    for (Point point : thinned(points, toleranceMm)) {
      Point whole = new Point(StrictMath.rint(point.xMm()), StrictMath.rint(point.yMm()));
      if (flat.isEmpty() || !flat.get(flat.size() - 1).equals(whole)) {
        flat.add(whole);
      }
    }
    return flat;
  }

  /** Those of the points that are needed to stay within {@code toleranceMm} of all of them. */
  public static List<Point> thinned(List<Point> points, double toleranceMm) {
    boolean[] isNeeded = new boolean[points.size()];
    if (!points.isEmpty()) {
      isNeeded[0] = true;
      isNeeded[points.size() - 1] = true;
      need(points, 0, points.size() - 1, toleranceMm, isNeeded);
    }
    List<Point> thinned = new ArrayList<>();
    for (int i = 0; i < points.size(); i++) {
      if (isNeeded[i]) {
        thinned.add(points.get(i));
      }
    }
    return thinned;
  }

  private static void need(
      List<Point> points, int from, int to, double toleranceMm, boolean[] isNeeded) {
    int[][] stack = new int[points.size() + 1][];
    int top = 0;
    stack[top++] = new int[] {from, to};
    while (top > 0) {
      int[] range = stack[--top];
      Segment chord = new Segment(points.get(range[0]), points.get(range[1]));
      int farthest = -1;
      double farthestMm = toleranceMm;
      for (int i = range[0] + 1; i < range[1]; i++) {
        double distanceMm = chord.distanceMm(points.get(i));
        if (distanceMm > farthestMm) {
          farthest = i;
          farthestMm = distanceMm;
        }
      }
      if (farthest >= 0) {
        isNeeded[farthest] = true;
        if (top + 2 > stack.length) {
          stack = Arrays.copyOf(stack, 2 * stack.length);
        }
        stack[top++] = new int[] {range[0], farthest};
        stack[top++] = new int[] {farthest, range[1]};
      }
    }
  }
}
