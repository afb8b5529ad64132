package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;

/**
 * Derives the rooms of a house from its walls and doors. With every {@link Doorway} shut, a flood
 * fill divides the floor into parts; a step goes from the centre of a cell to that of its neighbour
 * unless a wall or a shut door is between them. The part in which robots start is the hall. Where a
 * door has a part with a name on one side and a part without on the other, the latter becomes the
 * door's room. So a room may open from another room, and may have more doors than the one that
 * names it.
 */
final class Survey {

  private static final double BESIDE_DOOR_MM = 150;

  private final HousePlan plan;
  private final double clearanceMm;
  private final Grid grid;
  private final Sight sight;

  /**
   * Distance from each cell's centre to the nearest wall, exact up to the clearance; 0 inside one.
   */
  private final double[] toWallMm;

  private final List<Doorway> doorways = new ArrayList<>();

  /** Cells from which a step may lead through a shut door. */
  private final BitSet atDoors = new BitSet();

  /** The parts of the floor that walls and shut doors divide. */
  private final List<BitSet> parts = new ArrayList<>();

  Survey(HousePlan plan, double clearanceMm) {
    this.plan = plan;
    this.clearanceMm = clearanceMm;
    grid = new Grid(plan.bounds(), House.CELL_MM);
    sight = Sight.of(plan.walls());
    toWallMm = new double[grid.count()];
    measureWalls();
    plan.doors().forEach(this::shut);
    divide();
  }

  House house(double rangeMm) {
    List<BitSet> cells = roomParts();
    BitSet places = places();
    List<Room> rooms = new ArrayList<>();
    for (int i = 0; i < cells.size(); i++) {
      rooms.add(room(i, cells.get(i), places));
    }
    return new House(plan, rangeMm, grid, sight, places, rooms);
  }

  private void measureWalls() {
    Arrays.fill(toWallMm, Double.POSITIVE_INFINITY);
    for (Obstacle wall : plan.walls().all()) {
      for (Segment side : wall.sides()) {
        Rectangle box = Rectangle.around(List.of(side.from(), side.to()));
        grid.in(box.widened(clearanceMm + House.CELL_MM))
            .forEach(cell ->
                toWallMm[cell] = Math.min(toWallMm[cell], side.distanceMm(grid.centre(cell))));
      }
      if (wall.closed()) {
        grid.in(Rectangle.around(wall.points()))
            .filter(cell -> wall.distanceMm(grid.centre(cell)) == 0)
            .forEach(cell -> toWallMm[cell] = 0);
      }
    }
  }

  private void shut(ItemPosition door) {
    int cell = grid.cellAt(door.at());
    if (cell < 0 || toWallMm[cell] == 0) {
      throw new IllegalArgumentException(
          "door " + door.name() + " at " + door.at() + ": expected on the floor, in no wall");
    }
    Doorway doorway = Doorway.of(door, plan, sight);
    for (Segment leaf : doorway.leaves()) {
      Rectangle box = Rectangle.around(List.of(leaf.from(), leaf.to()));
      grid.in(box.widened(House.CELL_MM)).forEach(atDoors::set);
    }
    doorways.add(doorway);
  }

  private void divide() {
    BitSet free = new BitSet();
    for (int cell = 0; cell < toWallMm.length; cell++) {
      free.set(cell, toWallMm[cell] > 0);
    }
    while (!free.isEmpty()) {
      BitSet seed = new BitSet();
      seed.set(free.nextSetBit(0));
      BitSet part = grid.reached(seed, this::isOpen);
      parts.add(part);
      free.andNot(part);
    }
  }

  private boolean isOpen(int cell, int next) {
    if (toWallMm[next] == 0) {
      return false;
    }
    Point from = grid.centre(cell);
    Point to = grid.centre(next);
    boolean isNearWall = Math.min(toWallMm[cell], toWallMm[next]) <= House.CELL_MM;
    if (isNearWall && !sight.sees(from, to)) {
      return false;
    }
    return !atDoors.get(cell) || doorways.stream().noneMatch(door -> door.isBetween(from, to));
  }

  /** The part of the floor that is the room of each door, in the order of the doors. */
  private List<BitSet> roomParts() {
    List<BitSet> named = new ArrayList<>();
    for (Point start : plan.starts()) {
      int cell = grid.cellAt(start);
      named.add(
          parts.stream()
              .filter(part -> cell >= 0 && part.get(cell))
              .findFirst()
              .orElseThrow(() ->
                  new IllegalArgumentException(
                      "start at " + start + ": expected on the free floor")));
    }
    List<List<BitSet>> beside = new ArrayList<>();
    doorways.forEach(door -> beside.add(partsBeside(door)));
    BitSet[] rooms = new BitSet[doorways.size()];
    boolean isChanged = true;
    while (isChanged) {
      isChanged = false;
      for (int i = 0; i < rooms.length; i++) {
        boolean isFirstNamed = named.contains(beside.get(i).get(0));
        boolean isSecondNamed = named.contains(beside.get(i).get(1));
        if (rooms[i] == null && isFirstNamed != isSecondNamed) {
          rooms[i] = beside.get(i).get(isFirstNamed ? 1 : 0);
          named.add(rooms[i]);
          isChanged = true;
        }
      }
    }
    int without = Arrays.asList(rooms).indexOf(null);
    if (without >= 0) {
      throw new IllegalArgumentException(
          "door " + doorways.get(without).name() + ": expected a room of its own behind it");
    }
    return List.of(rooms);
  }

  private List<BitSet> partsBeside(Doorway door) {
    List<BitSet> beside = new ArrayList<>();
    for (BitSet part : parts) {
      if (grid.within(door.at(), BESIDE_DOOR_MM).anyMatch(part::get)) {
        beside.add(part);
      }
    }
    if (beside.size() != 2) {
      throw new IllegalArgumentException(
          String.format(
              "door %s at %s: expected to divide two parts of the floor, has %s beside it",
              door.name(), door.at(), beside.size()));
    }
    return beside;
  }

  /** Where a robot that comes from a start may stand. */
  private BitSet places() {
    BitSet free = new BitSet();
    for (int cell = 0; cell < toWallMm.length; cell++) {
      boolean isInside = plan.bounds().depthMm(grid.centre(cell)) >= clearanceMm;
      free.set(cell, isInside && toWallMm[cell] >= clearanceMm);
    }
    BitSet first = new BitSet();
    // A start itself may be nearer to a wall than the robot will ever be again.
    plan.starts().forEach(start -> grid.within(start, clearanceMm).forEach(first::set));
    first.and(free);
    return grid.reached(first, (cell, next) -> free.get(next));
  }

  private Room room(int index, BitSet cells, BitSet allPlaces) {
    BitSet places = (BitSet) cells.clone();
    places.and(allPlaces);
    Point door = doorways.get(index).at();
    Comparator<Point> byDoor = Comparator.comparingDouble(door::distanceMm);
    Comparator<Point> byAnyDoor =
        Comparator.comparingDouble(at ->
            doorways.stream()
                .mapToDouble(doorway -> doorway.distanceMm(at))
                .reduce(at.distanceMm(door), Math::min));
    return new Room(
        index,
        doorways.get(index).name(),
        door,
        cells,
        places,
        places.stream().mapToObj(grid::centre).min(byDoor).orElse(door),
        places.stream().mapToObj(grid::centre).max(byAnyDoor).orElse(door));
  }
}
