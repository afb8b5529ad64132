package org.starl.apps.intersection.spec;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;

/** The zones of each car's trip, in order, as the cars' programs have told; none for a parked one. */
final class Trips {

  private final Map<RobotId, List<String>> zones = new TreeMap<>();

  /**
   * Sees the next event. A robot that has left the floor is forgotten.
   *
   * @return whether a car has told its trip
   */
  boolean observe(TraceEvent event) {
    if (event instanceof TraceEvent.Left left) {
      zones.remove(left.robot());
    } else if (event instanceof Action action
        && action.source().equals(CrossingTrace.SOURCE)
        && action.name().equals(CrossingTrace.TRIP)) {
      zones.put(action.robot(), HeldZones.list(action.args().get(1)));
      return true;
    }
    return false;
  }

  /** Whether {@code robot} is a car, and is known to be. */
  boolean isCar(RobotId robot) {
    return zones.containsKey(robot);
  }

  /** Empty for a parked car, and for whoever is none. */
  List<String> of(RobotId robot) {
    return zones.getOrDefault(robot, List.of());
  }
}
