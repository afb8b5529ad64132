package org.starl.apps.search.logic;

import java.util.BitSet;
import org.starl.geometry.Point;

/** A room of a {@link House}: the cells behind a door. Immutable. */
public final class Room {

  private final int index;
  private final String name;
  private final Point door;
  private final BitSet cells;

  /** The same, one by one: with every report they are gone through. */
  private final int[] inOrder;

  private final BitSet places;
  private final Point entry;
  private final Point rest;

  /**
   * @param cells where a thing may lie
   * @param places cells in whose middle a robot may stand that has come in by the door
   * @param entry the place nearest to the door
   * @param rest the place farthest from all doors
   */
  Room(int index, String name, Point door, BitSet cells, BitSet places, Point entry, Point rest) {
    this.index = index;
    this.name = name;
    this.door = door;
    this.cells = cells;
    inOrder = cells.stream().toArray();
    this.places = places;
    this.entry = entry;
    this.rest = rest;
  }

  /** Its number in {@link House#rooms}. */
  public int index() {
    return index;
  }

  public String name() {
    return name;
  }

  public Point door() {
    return door;
  }

  /** Where a robot waits that has nothing to do: not in anybody's way. */
  public Point rest() {
    return rest;
  }

  Point entry() {
    return entry;
  }

  /** Whether a robot can get in. */
  public boolean isEnterable() {
    return !places.isEmpty();
  }

  /** How many cells it has. */
  public int size() {
    return inOrder.length;
  }

  /** Its cell number {@code at}, from 0. */
  int cell(int at) {
    return inOrder[at];
  }

  public void forEachCell(Grid.Visitor visitor) {
    for (int cell : inOrder) {
      visitor.visit(cell);
    }
  }

  /** A set of the caller's own. */
  BitSet cells() {
    return (BitSet) cells.clone();
  }

  /** A set of the caller's own. */
  BitSet places() {
    return (BitSet) places.clone();
  }

  boolean isPlace(int cell) {
    return cell >= 0 && places.get(cell);
  }

  /** Whether a straight way leads over cells in whose middle a robot may stand. */
  boolean hasPlacesAlong(Leg way, Grid grid) {
    int steps = 1 + (int) (2 * way.lengthMm() / grid.cellMm());
    for (int i = 0; i <= steps; i++) {
      if (!isPlace(grid.cellAt(way.at((double) i / steps)))) {
        return false;
      }
    }
    return true;
  }

  @Override
  public String toString() {
    return name;
  }
}
