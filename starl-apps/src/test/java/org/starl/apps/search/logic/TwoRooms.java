package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** A hall with the room A at its left end and B at its right one. */
public final class TwoRooms {

  /** The middle of the hall. */
  public static final Point HALL = new Point(4_000, 1_500);

  public static final House HOUSE = house();

  private TwoRooms() {}

  private static House house() {
    List<Obstacle> walls = new ArrayList<>();
    for (double x : new double[] {2_000, 6_000}) {
      walls.add(Obstacle.wall(new Point(x, 0), new Point(x, 1_000)));
      walls.add(Obstacle.wall(new Point(x, 2_000), new Point(x, 3_000)));
    }
    return House.of(
        new HousePlan(
            new Rectangle(0, 0, 8_000, 3_000),
            new Obstacles(walls),
            List.of(new ItemPosition("A", 2_000, 1_500), new ItemPosition("B", 6_000, 1_500)),
            List.of(HALL)),
        600,
        280);
  }
}
