package org.starl.apps.search.logic;

import java.util.List;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * A house as drawn: walls and doors, no rooms. Immutable.
 *
 * @param bounds all robots stay inside
 * @param walls every robot knows them
 * @param doors a point in each doorway, or just in front of it; a room has the name of its door
 * @param starts where robots start, at least one: the hall is the floor that can be reached from
 *     there without passing a door
 */
public record HousePlan(
    Rectangle bounds, Obstacles walls, List<ItemPosition> doors, List<Point> starts) {

  public HousePlan {
    doors = List.copyOf(doors);
    starts = List.copyOf(starts);
    if (starts.isEmpty()) {
      throw new IllegalArgumentException("a house without starts: expected at least one");
    }
  }
}
