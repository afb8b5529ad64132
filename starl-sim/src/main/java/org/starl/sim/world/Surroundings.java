package org.starl.sim.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/**
 * The bodies around one body: those whose centres are in range of its centre and, on request, in its
 * line of sight, which walls and other bodies cut ({@link World#sees}). One search of the grid finds
 * all of them, and allocates nothing unless walls are near. If many bodies ask at the same time, as
 * in a swarm with a common tick, a snapshot of the floor answers them. Used by one kernel.
 */
public final class Surroundings {

  private static final int LEAST_CAPACITY = 32;

  /** Taking a snapshot costs about as much as so many bodies, divided by this number, of searches. */
  private static final int BODIES_A_SEARCH = 32;

  private final World world;
  private final BodyGrid grid;
  private final WallGrid walls;
  private final BodyGrid.Visitor addBody = this::addBody;
  private final WallGrid.Visitor addWall;
  private final List<Wall> nearWalls = new ArrayList<>();

  private final FloorSnapshot snapshot = new FloorSnapshot();
  private boolean hasSnapshot;
  private int searches;
  private long changes;

  // The bodies near the centre, with positions relative to it.
  private double[] x = new double[LEAST_CAPACITY];
  private double[] y = new double[LEAST_CAPACITY];
  private double[] squareMm = new double[LEAST_CAPACITY];
  private double[] radiusMm = new double[LEAST_CAPACITY];
  private int[] numbers = new int[LEAST_CAPACITY];
  private int size;
  private int[] found = new int[LEAST_CAPACITY];
  private int foundCount;

  private int centerNumber;
  private double centerX;
  private double centerY;
  private double mostSquareMm;
  private long nowNs = -1;

  Surroundings(World world, BodyGrid grid, WallGrid walls) {
    this.world = world;
    this.grid = grid;
    this.walls = walls;
    this.addWall = nearWalls::add;
  }

  /**
   * Searches around {@code center}, which is not found itself. All bodies must have different
   * numbers ({@link Body#number}).
   *
   * @param needsSight whether only bodies in sight count
   * @return the number of bodies found, in no particular order
   */
  public int find(Body center, double rangeMm, boolean needsSight) {
    countSearch();
    center.moveTo(nowNs);
    centerNumber = center.number();
    centerX = center.xMm();
    centerY = center.yMm();
    // A body whose centre is out of range may still stand before one in range.
    double mostMm = rangeMm + (needsSight ? world.greatestRadiusMm() : 0);
    mostSquareMm = mostMm * mostMm;
    size = 0;
    if (hasSnapshot) {
      snapshot.find(centerX, centerY, mostMm, this);
    } else {
      grid.forEachNear(centerX, centerY, mostMm + Collider.REACH_MM, addBody);
    }
    if (needsSight) {
      nearWalls.clear();
      walls.forEachNear(centerX, centerY, rangeMm, nowNs, addWall);
    }
    foundCount = 0;
    for (int i = 0; i < size; i++) {
      if (squareMm[i] <= rangeMm * rangeMm && !(needsSight && isHidden(i))) {
        found[foundCount] = numbers[i];
        foundCount++;
      }
    }
    return foundCount;
  }

  /** The number of one of the bodies found by the last search. */
  public int number(int index) {
    return found[index];
  }

  private void countSearch() {
    if (nowNs != world.nowNs() || changes != world.changes()) {
      nowNs = world.nowNs();
      changes = world.changes();
      searches = 0;
      hasSnapshot = false;
    }
    searches++;
    if (!hasSnapshot && searches > world.size() / BODIES_A_SEARCH) {
      snapshot.take(world.all(), nowNs);
      hasSnapshot = true;
    }
  }

  private void addBody(Body body) {
    body.moveTo(nowNs);
    add(body.xMm(), body.yMm(), body.radiusMm(), body.number());
  }

  /** Adds a body if it is near. */
  void add(double bodyX, double bodyY, double bodyRadiusMm, int number) {
    double dx = bodyX - centerX;
    double dy = bodyY - centerY;
    double square = dx * dx + dy * dy;
    if (square > mostSquareMm || number == centerNumber) {
      return;
    }
    if (size == x.length) {
      grow();
    }
    x[size] = dx;
    y[size] = dy;
    squareMm[size] = square;
    radiusMm[size] = bodyRadiusMm;
    numbers[size] = number;
    size++;
  }

  private void grow() {
    x = Arrays.copyOf(x, 2 * size);
    y = Arrays.copyOf(y, 2 * size);
    squareMm = Arrays.copyOf(squareMm, 2 * size);
    radiusMm = Arrays.copyOf(radiusMm, 2 * size);
    numbers = Arrays.copyOf(numbers, 2 * size);
    found = Arrays.copyOf(found, 2 * size);
  }

  private boolean isHidden(int target) {
    for (int i = 0; i < size; i++) {
      if (i != target && cuts(i, target)) {
        return true;
      }
    }
    return !nearWalls.isEmpty() && isBehindAWall(target);
  }

  /** Whether body {@code i} cuts the line from the centre to {@code target}. */
  private boolean cuts(int i, int target) {
    double radiusSquare = radiusMm[i] * radiusMm[i];
    double cross = x[target] * y[i] - y[target] * x[i];
    if (cross * cross >= radiusSquare * squareMm[target]) {
      return squareMm[target] == 0 && squareMm[i] < radiusSquare;
    }
    double along = x[target] * x[i] + y[target] * y[i];
    if (along < 0) {
      return squareMm[i] < radiusSquare;
    }
    if (along <= squareMm[target]) {
      return true;
    }
    double dx = x[i] - x[target];
    double dy = y[i] - y[target];
    return dx * dx + dy * dy < radiusSquare;
  }

  private boolean isBehindAWall(int target) {
    Segment line =
        new Segment(
            new Point(centerX, centerY), new Point(centerX + x[target], centerY + y[target]));
    for (int i = 0; i < nearWalls.size(); i++) {
      if (nearWalls.get(i).crosses(line)) {
        return true;
      }
    }
    return false;
  }
}
