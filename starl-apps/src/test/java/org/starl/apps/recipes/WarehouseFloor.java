package org.starl.apps.recipes;

import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;

/** A west room with places to pick crates up, an aisle with room for one body, an east room. In mm. */
final class WarehouseFloor {

  static final Rectangle ALL = new Rectangle(0, 0, 12_000, 7_000);
  static final Rectangle AISLE = new Rectangle(4_000, 3_100, 8_000, 3_900);
  static final ItemPosition WEST_END = new ItemPosition("west-end", 3_400, 3_500);
  static final ItemPosition EAST_END = new ItemPosition("east-end", 8_600, 3_500);
  static final int PICKS = 3;
  static final int DROPS = 2;

  private WarehouseFloor() {}

  static ItemPosition home(int robot) {
    return new ItemPosition("home" + robot, 500, 600 + 820 * robot);
  }

  static ItemPosition bay(int robot) {
    return new ItemPosition("bay" + robot, 11_500, 600 + 820 * robot);
  }

  static ItemPosition pick(long order) {
    return new ItemPosition("pick" + order % PICKS, 2_000, 1_000 + 2_400 * (order % PICKS));
  }

  static ItemPosition drop(long order) {
    return new ItemPosition("drop" + order % DROPS, 10_000, 1_200 + 4_600 * (order % DROPS));
  }

  /** Whether a body may be in the aisle or at one of its ends. */
  static boolean isInAisle(Pose pose) {
    return pose.xMm() > WEST_END.at().xMm() - 300 && pose.xMm() < EAST_END.at().xMm() + 300;
  }

  static boolean isEast(Pose pose) {
    return pose.xMm() > AISLE.xMaxMm();
  }

  static Obstacles walls() {
    return Obstacles.of(block(0, AISLE.yMinMm()), block(AISLE.yMaxMm(), ALL.yMaxMm()));
  }

  private static Obstacle block(double fromMm, double toMm) {
    return Obstacle.body(
        new Point(AISLE.xMinMm(), fromMm),
        new Point(AISLE.xMaxMm(), fromMm),
        new Point(AISLE.xMaxMm(), toMm),
        new Point(AISLE.xMinMm(), toMm));
  }
}
