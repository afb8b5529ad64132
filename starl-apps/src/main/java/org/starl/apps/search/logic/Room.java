package org.starl.apps.search.logic;

import java.util.BitSet;
import org.starl.geometry.Point;

/**
 * A room of a {@link House}. Immutable: nothing may change its sets of cells.
 *
 * @param index its number in {@link House#rooms}
 * @param door the point of the door that names it
 * @param cells where a thing may lie
 * @param places cells in whose centre a robot may stand; empty if no robot can enter
 * @param entry the place nearest to the door
 * @param rest the place farthest from all doors: a robot without work waits there
 */
public record Room(
    int index, String name, Point door, BitSet cells, BitSet places, Point entry, Point rest) {

  /** Whether a robot can get in. */
  public boolean isEnterable() {
    return !places.isEmpty();
  }

  @Override
  public String toString() {
    return name;
  }
}
