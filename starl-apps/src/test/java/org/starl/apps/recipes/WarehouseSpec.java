package org.starl.apps.recipes;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.id.RobotId;
import org.starl.primitives.monitor.AppMonitor;
import org.starl.spec.Monitor;
import org.starl.spec.Require;
import org.starl.spec.RunState;

/** No order twice, none lost, and no opposing traffic in the aisle, by the true bodies. */
final class WarehouseSpec extends AppMonitor {

  private final int orders;
  private final SortedMap<Long, RobotId> delivered = new TreeMap<>();

  WarehouseSpec(int orders) {
    this.orders = orders;
    lemma("no_order_twice", "Each crate is delivered at most once.");
    lemma("no_order_lost", "At the end of the run every crate is delivered.");
    on(WarehouseApp.DELIVERED, this::onDelivered);
  }

  private void onDelivered(RobotId robot, long order) {
    if (order > 0) {
      RobotId before = delivered.putIfAbsent(order, robot);
      check("no_order_twice", before == null, List.of(robot), order + ", after " + before);
    }
  }

  @Override
  protected void onEnd() {
    int lost = orders - delivered.size();
    check("no_order_lost", lost == 0, List.of(), lost + " lost; delivered: " + delivered);
  }

  static Monitor oneWay() {
    return Require.always(
        "one_way", "All robots in the aisle drive in one direction.", WarehouseSpec::isOneWay);
  }

  private static boolean isOneWay(RunState state) {
    String seen = "";
    for (RobotId robot : state.robots()) {
      double mm = WarehouseFloor.AISLE.distanceMm(state.pose(robot).at());
      String lane = state.variable(robot, WarehouseApp.LANE);
      if (mm < state.radiusMm(robot) && !lane.isEmpty()) {
        if (!seen.isEmpty() && !seen.equals(lane)) {
          return false;
        }
        seen = lane;
      }
    }
    return true;
  }
}
