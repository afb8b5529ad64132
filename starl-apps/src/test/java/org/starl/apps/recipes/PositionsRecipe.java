package org.starl.apps.recipes;

import java.util.List;
import java.util.SortedMap;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Fix;
import org.starl.geometry.ItemPosition;
import org.starl.id.RobotId;

/** A recipe of docs/from-the-first-starl.md. */
final class PositionsRecipe extends LogicThread {

  PositionsRecipe(GlobalVarHolder gvh) {
    super(gvh);
  }

  @Override
  public List<Object> callStarL() {
    await(() -> gvh.gps.getPositions().size() == gvh.id.participants().size());
    SortedMap<RobotId, Fix> positions = gvh.gps.getPositions();
    ItemPosition dock = gvh.gps.getWaypointPosition("dock");
    if (dock == null) {
      return List.of("no waypoint dock");
    }
    RobotId nearest = gvh.id.name();
    for (RobotId robot : positions.keySet()) {
      double mm = positions.get(robot).pose().distanceMm(dock.at());
      nearest = mm < positions.get(nearest).pose().distanceMm(dock.at()) ? robot : nearest;
    }
    return List.of(nearest);
  }
}
