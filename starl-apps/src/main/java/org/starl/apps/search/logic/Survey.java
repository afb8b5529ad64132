package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;

/**
 * Derives rooms from walls and doors. With every {@link Doorway} shut the floor falls into parts, by
 * flood filling cell by cell: a step goes from one cell's middle to the next one's unless a wall or a
 * shut door is between them. The part in which robots start is the hall. Behind a door between a part
 * that has a name and one that has none lies a room, called as the door is; a room may be entered
 * through another one, and may have more doors than the one that gave it its name.
 */
final class Survey {

  private static final int UNKNOWN = -1;
  private static final double BESIDE_DOOR_MM = 150;

  private final HousePlan plan;
  private final double clearanceMm;
  private final Grid grid;
  private final Sight sight;
  private final double[] toWallMm;
  private final List<Doorway> doorways = new ArrayList<>();

  /** Cells from which a step may lead through a shut door. */
  private final BitSet atDoors = new BitSet();

  /** Of each cell the part of the floor in which it lies. */
  private final int[] part;

  Survey(HousePlan plan, double clearanceMm) {
    this.plan = plan;
    this.clearanceMm = clearanceMm;
    grid = new Grid(plan.bounds(), House.CELL_MM);
    sight = new Sight(plan.walls(), plan.bounds());
    toWallMm = new double[grid.count()];
    part = new int[grid.count()];
    measureWalls();
    for (ItemPosition door : plan.doors()) {
      int cell = grid.cellAt(door.at());
      if (cell < 0 || toWallMm[cell] == 0) {
        throw new IllegalArgumentException(
            "door " + door.name() + " at " + door.at() + ": expected on the floor, in no wall");
      }
      Doorway doorway = Doorway.of(door, plan, sight);
      for (Segment leaf : doorway.leaves()) {
        forEachCellNear(List.of(leaf.from(), leaf.to()), House.CELL_MM, atDoors::set);
      }
      doorways.add(doorway);
    }
    floodParts();
  }

  House house(double rangeMm) {
    int[] roomOfPart = namedParts();
    BitSet places = places();
    int[] labels = new int[grid.count()];
    BitSet[] cells = new BitSet[doorways.size()];
    for (int i = 0; i < cells.length; i++) {
      cells[i] = new BitSet();
    }
    for (int cell = 0; cell < labels.length; cell++) {
      labels[cell] = part[cell] == UNKNOWN ? House.NOWHERE : roomOfPart[part[cell]];
      if (labels[cell] >= 0) {
        cells[labels[cell]].set(cell);
      }
    }
    List<Room> rooms = new ArrayList<>();
    for (int i = 0; i < cells.length; i++) {
      rooms.add(room(i, cells[i], places));
    }
    return new House(plan, rangeMm, grid, sight, labels, places, rooms);
  }

  private void measureWalls() {
    Arrays.fill(toWallMm, Double.POSITIVE_INFINITY);
    for (Obstacle wall : plan.walls().all()) {
      for (Segment side : wall.sides()) {
        forEachCellNear(
            List.of(side.from(), side.to()),
            clearanceMm + House.CELL_MM,
            cell -> toWallMm[cell] = Math.min(toWallMm[cell], side.distanceMm(grid.centre(cell))));
      }
      if (wall.closed()) {
        forEachCellNear(
            wall.points(),
            0,
            cell -> {
              if (wall.distanceMm(grid.centre(cell)) == 0) {
                toWallMm[cell] = 0;
              }
            });
      }
    }
  }

  /** The cells of the box around some points, widened. */
  private void forEachCellNear(List<Point> points, double reachMm, Grid.Visitor visitor) {
    Rectangle box = Rectangle.around(points).widened(reachMm);
    int toRow = Math.min(grid.rows() - 1, grid.row(box.yMaxMm()));
    int toColumn = Math.min(grid.columns() - 1, grid.column(box.xMaxMm()));
    for (int row = Math.max(0, grid.row(box.yMinMm())); row <= toRow; row++) {
      for (int column = Math.max(0, grid.column(box.xMinMm())); column <= toColumn; column++) {
        visitor.visit(grid.cell(column, row));
      }
    }
  }

  private void floodParts() {
    Arrays.fill(part, UNKNOWN);
    int[] queue = new int[grid.count()];
    int parts = 0;
    for (int seed = 0; seed < part.length; seed++) {
      if (part[seed] != UNKNOWN || toWallMm[seed] == 0) {
        continue;
      }
      int head = 0;
      int tail = 0;
      queue[tail++] = seed;
      part[seed] = parts;
      while (head < tail) {
        int cell = queue[head++];
        for (int side = 0; side < 4; side++) {
          int next = grid.neighbour(cell, side);
          if (next >= 0 && part[next] == UNKNOWN && isOpen(cell, next)) {
            part[next] = parts;
            queue[tail++] = next;
          }
        }
      }
      parts++;
    }
  }

  private boolean isOpen(int cell, int next) {
    if (toWallMm[next] == 0) {
      return false;
    }
    Point from = grid.centre(cell);
    Point to = grid.centre(next);
    boolean nearWall = Math.min(toWallMm[cell], toWallMm[next]) <= House.CELL_MM;
    if (nearWall && !sight.sees(from, to)) {
      return false;
    }
    for (Doorway doorway : atDoors.get(cell) ? doorways : List.<Doorway>of()) {
      if (doorway.isBetween(from, to)) {
        return false;
      }
    }
    return true;
  }

  /** Of each part the number of its room, or HALL, or NOWHERE. */
  private int[] namedParts() {
    int parts = Arrays.stream(part).max().orElse(UNKNOWN) + 1;
    int[] named = new int[parts];
    Arrays.fill(named, House.NOWHERE);
    for (Point start : plan.starts()) {
      int cell = grid.cellAt(start);
      if (cell < 0 || part[cell] == UNKNOWN) {
        throw new IllegalArgumentException("start at " + start + ": expected on the free floor");
      }
      named[part[cell]] = House.HALL;
    }
    int[][] beside = new int[doorways.size()][];
    for (int i = 0; i < beside.length; i++) {
      beside[i] = partsBeside(doorways.get(i));
    }
    boolean[] isRoom = new boolean[beside.length];
    boolean more = true;
    while (more) {
      more = false;
      for (int i = 0; i < beside.length; i++) {
        int inside = isRoom[i] ? UNKNOWN : unnamedBehind(beside[i], named);
        if (inside != UNKNOWN) {
          named[inside] = i;
          isRoom[i] = true;
          more = true;
        }
      }
    }
    for (int i = 0; i < isRoom.length; i++) {
      if (!isRoom[i]) {
        throw new IllegalArgumentException(
            "door " + doorways.get(i).name() + ": expected a room of its own behind it");
      }
    }
    return named;
  }

  private static int unnamedBehind(int[] beside, int[] named) {
    boolean isFirst = named[beside[0]] != House.NOWHERE;
    boolean isSecond = named[beside[1]] != House.NOWHERE;
    if (isFirst == isSecond) {
      return UNKNOWN;
    }
    return isFirst ? beside[1] : beside[0];
  }

  private int[] partsBeside(Doorway doorway) {
    SortedMap<Integer, Integer> counts = new TreeMap<>();
    grid.forEachWithin(
        doorway.at(),
        BESIDE_DOOR_MM,
        cell -> {
          if (part[cell] != UNKNOWN) {
            counts.merge(part[cell], 1, Integer::sum);
          }
        });
    if (counts.size() != 2) {
      throw new IllegalArgumentException(
          "door "
              + doorway.name()
              + " at "
              + doorway.at()
              + ": expected to shut one part of the floor off from another, has "
              + counts.size()
              + " beside it");
    }
    return new int[] {counts.firstKey(), counts.lastKey()};
  }

  /** Where a robot may stand that comes from a start. */
  private BitSet places() {
    BitSet free = new BitSet();
    Rectangle bounds = plan.bounds();
    for (int cell = 0; cell < toWallMm.length; cell++) {
      double inMm = bounds.depthMm(grid.centre(cell));
      if (toWallMm[cell] >= clearanceMm && inMm >= clearanceMm) {
        free.set(cell);
      }
    }
    BitSet reached = new BitSet();
    int[] queue = new int[free.cardinality()];
    int tail = 0;
    for (Point start : plan.starts()) {
      // The robot itself may stand nearer to a wall than it will ever again.
      for (int cell = free.nextSetBit(0); cell >= 0; cell = free.nextSetBit(cell + 1)) {
        if (!reached.get(cell) && grid.centre(cell).distanceMm(start) <= clearanceMm) {
          reached.set(cell);
          queue[tail++] = cell;
        }
      }
    }
    for (int head = 0; head < tail; head++) {
      for (int side = 0; side < 4; side++) {
        int next = grid.neighbour(queue[head], side);
        if (next >= 0 && free.get(next) && !reached.get(next)) {
          reached.set(next);
          queue[tail++] = next;
        }
      }
    }
    return reached;
  }

  private Room room(int index, BitSet cells, BitSet allPlaces) {
    BitSet places = (BitSet) cells.clone();
    places.and(allPlaces);
    Point door = doorways.get(index).at();
    Point entry = door;
    Point rest = door;
    double nearestMm = Double.POSITIVE_INFINITY;
    double farthestMm = Double.NEGATIVE_INFINITY;
    for (int cell = places.nextSetBit(0); cell >= 0; cell = places.nextSetBit(cell + 1)) {
      Point at = grid.centre(cell);
      double toDoorMm = at.distanceMm(door);
      if (toDoorMm < nearestMm) {
        nearestMm = toDoorMm;
        entry = at;
      }
      double toAnyMm = toDoorMm;
      for (Doorway doorway : doorways) {
        toAnyMm = Math.min(toAnyMm, doorway.distanceMm(at));
      }
      if (toAnyMm > farthestMm) {
        farthestMm = toAnyMm;
        rest = at;
      }
    }
    return new Room(index, doorways.get(index).name(), door, cells, places, entry, rest);
  }
}
