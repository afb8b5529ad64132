package org.starl.apps.intersection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.RobotId;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Region;
import org.starl.motion.MotionFlag;
import org.starl.sim.Director;
import org.starl.sim.SimControl;

/**
 * Cars come and go: a car appears at the head of its lane once it is ready and nobody is left in the
 * arrival zone; one that has come to a stand at the end of a road, has given back all its zones and
 * so has stopped its motion ({@code IDLE}) leaves the floor.
 */
final class Traffic implements Director {

  private static final long LOOK_EVERY_NS = 100_000_000;

  private final double radiusMm;
  private final List<Region> exits = new ArrayList<>();
  private final SortedMap<String, Deque<Car>> lanes = new TreeMap<>();
  private final List<Car> onFloor = new ArrayList<>();

  Traffic(Crossing crossing, double radiusMm, List<Car> cars) {
    this.radiusMm = radiusMm;
    for (Zone zone : Zone.values()) {
      exits.add(crossing.exitRegion(zone));
    }
    for (Car car : cars) {
      lanes.computeIfAbsent(car.lane(), lane -> new ArrayDeque<>()).add(car);
    }
  }

  @Override
  public void direct(SimControl control) {
    look(control);
  }

  private void look(SimControl control) {
    onFloor.removeIf(car -> leaves(control, car));
    for (Deque<Car> lane : lanes.values()) {
      Car first = lane.peek();
      if (first != null && first.readyNs() <= control.nowNs() && appears(control, first)) {
        onFloor.add(lane.remove());
      }
    }
    if (!onFloor.isEmpty() || lanes.values().stream().anyMatch(lane -> !lane.isEmpty())) {
      control.at(control.nowNs() + LOOK_EVERY_NS, () -> look(control));
    }
  }

  private boolean appears(SimControl control, Car car) {
    for (Car other : onFloor) {
      double apartMm = control.truePose(other.id()).distanceMm(car.start().at());
      if (apartMm < clearanceMm()) {
        return false;
      }
    }
    return control.putOnFloor(car.id());
  }

  /** Between the middles of two cars, one of which has left the arrival zone of the other. */
  private double clearanceMm() {
    return 3 * radiusMm;
  }

  private boolean leaves(SimControl control, Car car) {
    RobotId id = car.id();
    if (control.motionflag(id) != MotionFlag.IDLE) {
      return false;
    }
    for (Region exit : exits) {
      if (exit.contains(control.truePose(id).at())) {
        control.takeOffFloor(id);
        return true;
      }
    }
    return false;
  }
}
