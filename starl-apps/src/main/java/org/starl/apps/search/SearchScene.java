package org.starl.apps.search;

import java.util.List;
import java.util.Map;
import org.starl.apps.search.logic.House;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * A search to simulate. Immutable.
 *
 * @param house as robots know it
 * @param starts where each robot starts, in the order in which robots join
 * @param things the things to find; may be none
 */
record SearchScene(House house, Map<RobotId, Pose> starts, List<ItemPosition> things) {

  SearchScene withThings(List<ItemPosition> newThings) {
    return new SearchScene(house, starts, List.copyOf(newThings));
  }
}
