package org.starl.apps.search.logic;

import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;

/**
 * The map that every robot has of the house: its rooms, which {@link Survey} derives from walls and
 * doors, and where a robot may stand. The floor is divided into cells of {@link #CELL_MM}.
 * Immutable.
 */
public final class House {

  static final int CELL_MM = 50;

  /**
   * How far a robot may stand, or believe to stand, from its goal along each axis: goal radius and
   * position error.
   */
  static final double SLACK_MM = 50;

  private static final double NEAR_MM = 400;

  private final HousePlan plan;
  private final double rangeMm;
  private final Grid grid;
  private final Sight sight;
  private final BitSet places;
  private final List<Room> rooms;

  House(HousePlan plan, double rangeMm, Grid grid, Sight sight, BitSet places, List<Room> rooms) {
    this.plan = plan;
    this.rangeMm = rangeMm;
    this.grid = grid;
    this.sight = sight;
    this.places = places;
    this.rooms = List.copyOf(rooms);
  }

  /**
   * The house of a plan.
   *
   * @param rangeMm how far the robots' sensors reach, in line of sight
   * @param clearanceMm how far from every wall a robot's centre stays
   * @throws IllegalArgumentException naming the door or the start from which no house can be
   *     derived
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

  /** The number of the room in which a point lies; -1 if it is in none. */
  public int roomAt(Point point) {
    int cell = grid.cellAt(point);
    return rooms.stream()
        .filter(room -> cell >= 0 && room.cells().get(cell))
        .findFirst()
        .map(Room::index)
        .orElse(-1);
  }

  /**
   * Those of some cells that a sensor within {@code errorMm} of {@code at}, along each axis, sees
   * whole.
   */
  BitSet view(Point at, double errorMm, BitSet among) {
    Sight near = sight.near(at, rangeMm);
    BitSet view = new BitSet();
    grid.within(at, rangeMm)
        .filter(among::get)
        .filter(cell -> near.seesAll(at, errorMm, grid.centre(cell), CELL_MM / 2.0, rangeMm))
        .forEach(view::set);
    return view;
  }

  /** Whether a robot can see all of a cell from some place, in whatever room. */
  public boolean canBeSeen(int cell) {
    return canBeSeen(cell, places);
  }

  /** Whether a robot can see all of a cell from one of some places. */
  public boolean canBeSeen(int cell, BitSet among) {
    Point centre = grid.centre(cell);
    Sight near = sight.near(centre, rangeMm);
    return grid.within(centre, rangeMm)
        .filter(among::get)
        .anyMatch(
            place -> near.seesAll(grid.centre(place), SLACK_MM, centre, CELL_MM / 2.0, rangeMm));
  }

  /**
   * How far a robot has to drive from a point to the entry of each room, in mm along the grid's
   * axes; {@code Integer.MAX_VALUE} where no way leads.
   */
  public int[] distancesMm(Point from) {
    int[] steps = grid.steps(placeNear(from, places), (cell, next) -> places.get(next));
    return rooms.stream()
        .mapToInt(room -> room.isEnterable() ? steps[grid.cellAt(room.entry())] : -1)
        .map(count -> count < 0 ? Integer.MAX_VALUE : count * CELL_MM)
        .toArray();
  }

  /** Where a robot may stand, in whatever room or the hall; the caller may change the set. */
  public BitSet places() {
    return (BitSet) places.clone();
  }

  /** Takes the places that are nearer than this to a line out of {@code open}. */
  public void bar(Segment line, double nearMm, BitSet open) {
    for (int cell = open.nextSetBit(0); cell >= 0; cell = open.nextSetBit(cell + 1)) {
      if (line.distanceMm(grid.centre(cell)) < nearMm) {
        open.clear(cell);
      }
    }
  }

  /** The open places that can be reached from a point over open places. */
  public BitSet reachable(Point from, BitSet open) {
    return grid.reached(placeNear(from, open), (cell, next) -> open.get(next));
  }

  /** The open place that is nearest to a point; empty if none is near. */
  private BitSet placeNear(Point point, BitSet open) {
    BitSet nearest = new BitSet();
    grid.within(point, NEAR_MM)
        .filter(open::get)
        .boxed()
        .min(Comparator.comparingDouble(cell -> grid.centre(cell).distanceMm(point)))
        .ifPresent(nearest::set);
    return nearest;
  }
}
