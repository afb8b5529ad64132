package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;

/**
 * Derives the rooms of a house from its walls and doors. With every door shut, a flood fill divides
 * the floor into parts; a step goes from the centre of a cell to that of its neighbour unless a
 * wall or a shut door is between them. The part in which robots start is the hall. Where a door has
 * a part with a name on one side and a part without on the other, the latter becomes the door's
 * room. So a room may open from another room, and may have more doors than the one that names it.
 */
final class Survey {

  private static final double BESIDE_DOOR_MM = 150;

  /** The walls beside a door are at least 84 degrees apart: the cosine of that angle. */
  private static final double MAX_COSINE = 0.1;

  /** A shut door ends so far inside the walls beside it. */
  private static final double OVERLAP_MM = 1;

  private final HousePlan plan;
  private final double clearanceMm;
  private final Grid grid;
  private final Sight sight;

  /**
   * Distance from each cell's centre to the nearest wall, exact up to the clearance; 0 inside one.
   */
  private final double[] toWallMm;

  /** The lines that shut the doors. */
  private final List<Segment> leaves = new ArrayList<>();

  /** The parts of the floor that walls and shut doors divide. */
  private final List<BitSet> parts = new ArrayList<>();

  Survey(HousePlan plan, double clearanceMm) {
    this.plan = plan;
    this.clearanceMm = clearanceMm;
    grid = new Grid(plan.bounds(), House.CELL_MM);
    sight = new Sight(sides());
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

  private List<Segment> sides() {
    return plan.walls().all().stream()
        .flatMap(wall -> wall.sides().stream())
        .collect(Collectors.toList());
  }

  private void measureWalls() {
    Arrays.fill(toWallMm, Double.POSITIVE_INFINITY);
    for (Segment side : sides()) {
      cellsNear(side, clearanceMm + House.CELL_MM)
          .forEach(cell ->
              toWallMm[cell] = Math.min(toWallMm[cell], side.distanceMm(grid.centre(cell))));
    }
    for (Obstacle wall : plan.walls().all()) {
      grid.in(Rectangle.around(wall.points()))
          .filter(cell -> wall.distanceMm(grid.centre(cell)) == 0)
          .forEach(cell -> toWallMm[cell] = 0);
    }
  }

  private IntStream cellsNear(Segment line, double nearMm) {
    return grid.in(Rectangle.around(List.of(line.from(), line.to())).widened(nearMm));
  }

  /**
   * Shuts a door by two lines from its point to the walls beside it. Of all pairs of walls that the
   * point sees, at least 84 degrees apart, takes the pair with the shortest way from one wall over
   * the point to the other.
   */
  private void shut(ItemPosition door) {
    Point at = door.at();
    int cell = grid.cellAt(at);
    if (cell < 0 || toWallMm[cell] == 0) {
      throw badDoor(door, "on the floor, in no wall");
    }
    List<Segment> candidates =
        sides().stream()
            .map(side -> new Segment(at, side.nearest(at)))
            .filter(leaf -> lengthMm(leaf) > OVERLAP_MM && sight.sees(at, end(leaf, -OVERLAP_MM)))
            .collect(Collectors.toList());
    double shortestMm = Double.POSITIVE_INFINITY;
    List<Segment> best = List.of();
    for (Segment left : candidates) {
      for (Segment right : candidates) {
        double mm = lengthMm(left) + lengthMm(right);
        double dot = left.to().minus(at).dot(right.to().minus(at));
        if (mm < shortestMm && dot <= MAX_COSINE * lengthMm(left) * lengthMm(right)) {
          shortestMm = mm;
          best = List.of(left, right);
        }
      }
    }
    if (best.isEmpty()) {
      throw badDoor(door, "a wall on either side");
    }
    best.forEach(leaf -> leaves.add(new Segment(at, end(leaf, OVERLAP_MM))));
  }

  private static double lengthMm(Segment line) {
    return line.from().distanceMm(line.to());
  }

  /** The end of a line that is longer by so much. */
  private static Point end(Segment line, double byMm) {
    return line.to().plus(line.to().minus(line.from()).times(byMm / lengthMm(line)));
  }

  private static IllegalArgumentException badDoor(ItemPosition door, String expected) {
    return new IllegalArgumentException(
        "door " + door.name() + " at " + door.at() + ": expected " + expected);
  }

  private void divide() {
    List<Segment> lines = sides();
    lines.addAll(leaves);
    Sight shut = new Sight(lines);
    BitSet nearLine = new BitSet();
    lines.forEach(line -> cellsNear(line, House.CELL_MM).forEach(nearLine::set));
    BitSet free = cells(cell -> toWallMm[cell] > 0);
    while (!free.isEmpty()) {
      BitSet seed = new BitSet();
      seed.set(free.nextSetBit(0));
      BitSet part =
          grid.reached(
              seed,
              (cell, next) ->
                  toWallMm[next] > 0
                      && (!nearLine.get(cell) || shut.sees(grid.centre(cell), grid.centre(next))));
      parts.add(part);
      free.andNot(part);
    }
  }

  private BitSet cells(IntPredicate isIn) {
    BitSet cells = new BitSet();
    IntStream.range(0, grid.count()).filter(isIn).forEach(cells::set);
    return cells;
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
    List<ItemPosition> doors = plan.doors();
    BitSet[] rooms = new BitSet[doors.size()];
    int before = -1;
    while (named.size() > before) {
      before = named.size();
      for (int i = 0; i < rooms.length; i++) {
        List<BitSet> unnamed = partsBeside(doors.get(i));
        unnamed.removeAll(named);
        if (rooms[i] == null && unnamed.size() == 1) {
          rooms[i] = unnamed.get(0);
          named.add(rooms[i]);
        }
      }
    }
    int without = Arrays.asList(rooms).indexOf(null);
    if (without >= 0) {
      throw badDoor(doors.get(without), "a room of its own behind it");
    }
    return List.of(rooms);
  }

  private List<BitSet> partsBeside(ItemPosition door) {
    List<BitSet> beside =
        parts.stream()
            .filter(part -> grid.within(door.at(), BESIDE_DOOR_MM).anyMatch(part::get))
            .collect(Collectors.toList());
    if (beside.size() != 2) {
      throw badDoor(door, "two parts of the floor beside it, has " + beside.size());
    }
    return beside;
  }

  /** Where a robot that comes from a start may stand. */
  private BitSet places() {
    BitSet free =
        cells(cell ->
            toWallMm[cell] >= clearanceMm
                && plan.bounds().depthMm(grid.centre(cell)) >= clearanceMm);
    BitSet first = new BitSet();
    // A start itself may be nearer to a wall than the robot will ever be again.
    plan.starts().forEach(start -> grid.within(start, clearanceMm).forEach(first::set));
    first.and(free);
    return grid.reached(first, (cell, next) -> free.get(next));
  }

  private Room room(int index, BitSet cells, BitSet allPlaces) {
    BitSet places = (BitSet) cells.clone();
    places.and(allPlaces);
    ItemPosition door = plan.doors().get(index);
    Comparator<Point> byDoor = Comparator.comparingDouble(door.at()::distanceMm);
    Comparator<Point> byAnyDoor = Comparator.comparingDouble(this::toDoorMm);
    return new Room(
        index,
        door.name(),
        door.at(),
        cells,
        places,
        places.stream().mapToObj(grid::centre).min(byDoor).orElse(door.at()),
        places.stream().mapToObj(grid::centre).max(byAnyDoor).orElse(door.at()));
  }

  private double toDoorMm(Point at) {
    return leaves.stream().mapToDouble(leaf -> leaf.distanceMm(at)).min().orElse(0);
  }
}
