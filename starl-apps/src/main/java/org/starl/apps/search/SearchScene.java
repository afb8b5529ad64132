package org.starl.apps.search;

import java.util.List;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * A search to be simulated.
 *
 * @param house as robots know it
 * @param robots who searches
 * @param things to find; none is fine
 */
record SearchScene(House house, List<Start> robots, List<ItemPosition> things) {

  /** A robot and where it starts. */
  record Start(RobotId robot, Pose pose) {}

  SearchScene {
    robots = List.copyOf(robots);
    things = List.copyOf(things);
  }

  HousePlan plan() {
    return house.plan();
  }
}
