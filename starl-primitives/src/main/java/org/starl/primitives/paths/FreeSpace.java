package org.starl.primitives.paths;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.locationtech.jts.geom.Coordinate;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * The points where the centre of a body may be: a rectangle without the interiors of polygons;
 * their borders are free. All corners are in whole mm, and every answer is exact. Not for
 * concurrent use.
 */
final class FreeSpace {

  /** The corners, each with its neighbours on its ring. */
  private final int[] x;

  private final int[] y;
  private final int[] next;
  private final int[] previous;
  private final EdgeGrid grid;
  private final Rooms rooms;
  private final int xMin;
  private final int yMin;
  private final int xMax;
  private final int yMax;
  private final TouchedCorners touches = new TouchedCorners();

  /**
   * @param rings closed, in whole mm, the solid side on the left; may touch, but not cross
   */
  FreeSpace(List<Coordinate[]> rings, Rectangle bounds, double marginMm) {
    int count = rings.stream().mapToInt(ring -> ring.length - 1).sum();
    x = new int[count];
    y = new int[count];
    next = new int[count];
    previous = new int[count];
    int first = 0;
    for (Coordinate[] ring : rings) {
      int length = ring.length - 1;
      for (int i = 0; i < length; i++) {
        x[first + i] = whole(ring[i].x);
        y[first + i] = whole(ring[i].y);
        next[first + i] = first + (i + 1) % length;
        previous[first + i] = first + (i + length - 1) % length;
      }
      first += length;
    }
    xMin = low(bounds.xMinMm(), marginMm);
    yMin = low(bounds.yMinMm(), marginMm);
    xMax = high(bounds.xMaxMm(), marginMm);
    yMax = high(bounds.yMaxMm(), marginMm);
    grid = new EdgeGrid(x, y, next);
    rooms = new Rooms(rings);
  }

  private static int low(double mm, double marginMm) {
    return whole(StrictMath.ceil(mm + marginMm));
  }

  private static int high(double mm, double marginMm) {
    return whole(StrictMath.floor(mm - marginMm));
  }

  /** The bounds of the centre; null if they have no area. */
  static @Nullable Rectangle inner(Rectangle bounds, double marginMm) {
    int left = low(bounds.xMinMm(), marginMm);
    int bottom = low(bounds.yMinMm(), marginMm);
    int right = high(bounds.xMaxMm(), marginMm);
    int top = high(bounds.yMaxMm(), marginMm);
    return left < right && bottom < top ? new Rectangle(left, bottom, right, top) : null;
  }

  /** The room of a free point, or {@link Rooms#NONE}; no path connects two rooms. */
  int room(int px, int py) {
    return rooms.at(px, py);
  }

  /** Whether a room may reach one of these sides of the bounds; true if the room is unknown. */
  boolean reachesSide(int room, boolean left, boolean bottom, boolean right, boolean top) {
    return room == Rooms.NONE
        || (left && rooms.box(room).getMinX() <= xMin)
        || (bottom && rooms.box(room).getMinY() <= yMin)
        || (right && rooms.box(room).getMaxX() >= xMax)
        || (top && rooms.box(room).getMaxY() >= yMax);
  }

  /** The nearest whole number of mm. */
  static int whole(double mm) {
    long rounded = StrictMath.round(mm);
    if (Math.abs(rounded) > 2L * PlanTask.MAX_MM) {
      throw new IllegalArgumentException(mm + " mm: expected within 268 km of 0");
    }
    return (int) rounded;
  }

  static int x(Point point) {
    return whole(point.xMm());
  }

  static int y(Point point) {
    return whole(point.yMm());
  }

  int corners() {
    return x.length;
  }

  int cornerX(int corner) {
    return x[corner];
  }

  int cornerY(int corner) {
    return y[corner];
  }

  int xMin() {
    return xMin;
  }

  int yMin() {
    return yMin;
  }

  int xMax() {
    return xMax;
  }

  int yMax() {
    return yMax;
  }

  /** Whether the centre of a body may be there. */
  boolean isFree(int px, int py) {
    return isInBounds(px, py) && !isSolid(2L * px, 2L * py);
  }

  boolean isInBounds(int px, int py) {
    return xMin <= px && px <= xMax && yMin <= py && py <= yMax;
  }

  /** Whether a shortest path may turn at this corner: the solid angle is below 180 degrees. */
  boolean sticksOut(int corner) {
    int before = previous[corner];
    int after = next[corner];
    return isInBounds(x[corner], y[corner])
        && orientation(x[before], y[before], x[corner], y[corner], x[after], y[after]) > 0;
  }

  /**
   * Whether the line from (px, py) passes the corner without entering the solid side. A shortest
   * path has only such lines.
   */
  boolean isTangent(int px, int py, int corner) {
    int a = side(px, py, corner, previous[corner]);
    int b = side(px, py, corner, next[corner]);
    return a * b >= 0;
  }

  private int side(int px, int py, int corner, int other) {
    return Long.signum(orientation(px, py, x[corner], y[corner], x[other], y[other]));
  }

  /** Whether the straight line between two free points is free. */
  boolean sees(int px, int py, int qx, int qy) {
    touches.begin(px, py);
    grid.begin(px, py, qx, qy);
    for (int edge = grid.nextEdge(); edge >= 0; edge = grid.nextEdge()) {
      if (blocks(edge, px, py, qx, qy)) {
        return false;
      }
    }
    // Between two touched corners the line is either all solid or all free.
    touches.end(qx, qy);
    for (int i = 1; i < touches.size(); i++) {
      if (isSolid((long) touches.x(i - 1) + touches.x(i), (long) touches.y(i - 1) + touches.y(i))) {
        return false;
      }
    }
    return true;
  }

  private boolean blocks(int a, int px, int py, int qx, int qy) {
    int b = next[a];
    int sideA = Long.signum(orientation(px, py, qx, qy, x[a], y[a]));
    int sideB = Long.signum(orientation(px, py, qx, qy, x[b], y[b]));
    if (sideA == 0 && isBetween(x[a], y[a], px, py, qx, qy)) {
      touches.add(x[a], y[a]);
    }
    if (sideA * sideB >= 0) {
      return false;
    }
    int sideP = Long.signum(orientation(x[a], y[a], x[b], y[b], px, py));
    int sideQ = Long.signum(orientation(x[a], y[a], x[b], y[b], qx, qy));
    return sideP * sideQ < 0;
  }

  /** Whether a lies in the bounding box of p and q. */
  static boolean isBetween(long ax, long ay, long px, long py, long qx, long qy) {
    return Math.min(px, qx) <= ax
        && ax <= Math.max(px, qx)
        && Math.min(py, qy) <= ay
        && ay <= Math.max(py, qy);
  }

  /** Whether a point, given by twice its coordinates, is inside a polygon and not on its border. */
  private boolean isSolid(long x2, long y2) {
    boolean inside = false;
    grid.beginLeftOf(x2, y2);
    for (int a = grid.nextEdge(); a >= 0; a = grid.nextEdge()) {
      int b = next[a];
      long ax = 2L * x[a];
      long ay = 2L * y[a];
      long bx = 2L * x[b];
      long by = 2L * y[b];
      long turn = (bx - ax) * (y2 - ay) - (by - ay) * (x2 - ax);
      if (turn == 0 && isBetween(x2, y2, ax, ay, bx, by)) {
        return false;
      }
      // The ray from the point to the left crosses the edge.
      if ((ay > y2) != (by > y2) && (turn < 0) == (by > ay)) {
        inside = !inside;
      }
    }
    return inside;
  }

  /** Above 0 if c is left of the line from a to b, 0 if on it; exact. */
  private static long orientation(int ax, int ay, int bx, int by, int cx, int cy) {
    return ((long) bx - ax) * ((long) cy - ay) - ((long) by - ay) * ((long) cx - ax);
  }
}
