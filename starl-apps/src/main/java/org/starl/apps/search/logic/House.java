package org.starl.apps.search.logic;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;

/**
 * What every robot knows of the house: its rooms, derived from walls and doors by {@link Survey}, and
 * where a robot may stand in them. All is looked at cell by cell, {@link #CELL_MM} wide. Immutable.
 */
public final class House {

  public static final int CELL_MM = 50;

  /** A cell in neither a room nor the hall: solid, or out of reach. */
  static final int NOWHERE = -1;

  /** The label of the cells of the hall; those of a room have its number. */
  static final int HALL = -2;

  /**
   * A robot that is to stand in a place may stand, and believe to stand, so far from it along each
   * axis: goal radius and position error.
   */
  static final double SLACK_MM = 50;

  private static final double NEAR_MM = 400;

  private final HousePlan plan;
  private final double rangeMm;
  private final Grid grid;
  private final Sight sight;
  private final int[] labels;
  private final BitSet places;
  private final List<Room> rooms;

  House(
      HousePlan plan,
      double rangeMm,
      Grid grid,
      Sight sight,
      int[] labels,
      BitSet places,
      List<Room> rooms) {
    this.plan = plan;
    this.rangeMm = rangeMm;
    this.grid = grid;
    this.sight = sight;
    this.labels = labels;
    this.places = places;
    this.rooms = List.copyOf(rooms);
  }

  /**
   * The house of a plan.
   *
   * @param rangeMm how far the robots' sensors reach, in line of sight
   * @param clearanceMm how far from every wall a robot's centre stays
   * @throws IllegalArgumentException naming the door, if it shuts nothing off or leads nowhere
   */
  public static House of(HousePlan plan, double rangeMm, double clearanceMm) {
    return new Survey(plan, clearanceMm).house(rangeMm);
  }

  /** In the order of their doors. */
  public List<Room> rooms() {
    return rooms;
  }

  public Room room(int index) {
    return rooms.get(index);
  }

  public Grid grid() {
    return grid;
  }

  public Sight sight() {
    return sight;
  }

  public HousePlan plan() {
    return plan;
  }

  public Rectangle bounds() {
    return plan.bounds();
  }

  public double rangeMm() {
    return rangeMm;
  }

  /** The number of the room in which a point lies; below 0 if it is in none. */
  public int roomAt(Point point) {
    int cell = grid.cellAt(point);
    return cell < 0 ? NOWHERE : labels[cell];
  }

  /** Whether a sensor within {@code errorMm} of {@code at}, along each axis, has all of a cell in view. */
  public boolean covers(Point at, double errorMm, int cell) {
    return sight.seesAll(at, errorMm, grid.centre(cell), CELL_MM / 2.0, rangeMm);
  }

  /** Whether there is a place, in whatever room, from where a robot can see all of a cell. */
  public boolean canBeSeen(int cell) {
    return canBeSeen(cell, places);
  }

  /** Whether there is one among some places. */
  public boolean canBeSeen(int cell, BitSet among) {
    boolean[] found = {false};
    grid.forEachWithin(
        grid.centre(cell),
        rangeMm,
        place ->
            found[0] =
                found[0] || (among.get(place) && covers(grid.centre(place), SLACK_MM, cell)));
    return found[0];
  }

  /**
   * How far it is from a point to the entry of each room, for robots, in mm along the grid's axes;
   * {@code Integer.MAX_VALUE} where there is no way.
   */
  public int[] distancesMm(Point from) {
    int[] steps = stepsFrom(from, places);
    int[] distances = new int[rooms.size()];
    for (Room room : rooms) {
      int cell = grid.cellAt(room.entry());
      boolean isThere = room.isEnterable() && steps[cell] >= 0;
      distances[room.index()] = isThere ? steps[cell] * CELL_MM : Integer.MAX_VALUE;
    }
    return distances;
  }

  /** Where a robot may stand, in whatever room or the hall; a set of the caller's own. */
  public BitSet places() {
    return (BitSet) places.clone();
  }

  /** Takes out of {@code open} the places that are nearer than this to a line. */
  public void bar(Segment line, double nearMm, BitSet open) {
    for (int cell = open.nextSetBit(0); cell >= 0; cell = open.nextSetBit(cell + 1)) {
      if (line.distanceMm(grid.centre(cell)) < nearMm) {
        open.clear(cell);
      }
    }
  }

  /** The places to which a way leads over places that are open. */
  public BitSet reachable(Point from, BitSet open) {
    int[] steps = stepsFrom(from, open);
    BitSet reached = new BitSet();
    for (int cell = 0; cell < steps.length; cell++) {
      reached.set(cell, steps[cell] >= 0);
    }
    return reached;
  }

  private int[] stepsFrom(Point from, BitSet open) {
    int[] steps = new int[grid.count()];
    Arrays.fill(steps, -1);
    int start = placeNear(from, open);
    if (start < 0) {
      return steps;
    }
    int[] queue = new int[open.cardinality()];
    int head = 0;
    int tail = 0;
    queue[tail++] = start;
    steps[start] = 0;
    while (head < tail) {
      int cell = queue[head++];
      for (int side = 0; side < 4; side++) {
        int next = grid.neighbour(cell, side);
        if (next >= 0 && open.get(next) && steps[next] < 0) {
          steps[next] = steps[cell] + 1;
          queue[tail++] = next;
        }
      }
    }
    return steps;
  }

  /** The open place nearest to a point, or -1 if there is none near. */
  private int placeNear(Point point, BitSet open) {
    int[] best = {-1};
    double[] bestMm = {Double.POSITIVE_INFINITY};
    grid.forEachWithin(
        point,
        NEAR_MM,
        cell -> {
          double mm = grid.centre(cell).distanceMm(point);
          if (open.get(cell) && mm < bestMm[0]) {
            best[0] = cell;
            bestMm[0] = mm;
          }
        });
    return best[0];
  }
}
