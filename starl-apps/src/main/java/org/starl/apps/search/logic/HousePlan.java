package org.starl.apps.search.logic;

import java.util.List;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * A house as somebody draws it: walls and doors, no rooms. Immutable.
 *
 * @param bounds all robots stay inside
 * @param walls that everybody knows
 * @param doors a point in each doorway, or just before it; a room is called as its door is
 * @param starts where robots come from, at least one: what can be reached from there without
 *     passing a door is the hall
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
