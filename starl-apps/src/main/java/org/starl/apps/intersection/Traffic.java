package org.starl.apps.intersection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.sim.Director;
import org.starl.sim.SimControl;

/**
 * Cars come and go: a car appears at the head of its lane once it is ready and nobody is left in the
 * arrival zone; one that has come to a stand at the end of a road, and has given back all its zones,
 * leaves the floor.
 */
final class Traffic implements Director {

  private static final long LOOK_EVERY_NS = 100_000_000;

  private final double radiusMm;
  private final List<Region> exits = new ArrayList<>();
  private final SortedMap<String, Deque<Car>> lanes = new TreeMap<>();
  private final List<Car> cars;
  private final List<Car> onFloor = new ArrayList<>();
  private final Operator operator;
  private boolean isOver;

  Traffic(Crossing crossing, double radiusMm, List<Car> cars, Operator operator) {
    this.radiusMm = radiusMm;
    this.cars = List.copyOf(cars);
    this.operator = operator;
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
    cars.forEach(car -> operator.look(control, car.id()));
    onFloor.removeIf(car -> leaves(control, car));
    for (Deque<Car> lane : lanes.values()) {
      Car first = lane.peek();
      if (first != null && first.readyNs() <= control.nowNs() && appears(control, first)) {
        onFloor.add(lane.remove());
      }
    }
    isOver =
        lanes.values().stream().allMatch(Deque::isEmpty)
            && cars.stream().allMatch(car -> control.isFinished(car.id()));
    if (!isOver) {
      control.at(control.nowNs() + LOOK_EVERY_NS, () -> look(control));
    }
  }

  @Override
  public boolean isOver() {
    return isOver;
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
    if (!control.isOnFloor(id)) {
      return true;
    }
    if (!operator.isReady(id)) {
      return false;
    }
    for (Region exit : exits) {
      if (exit.contains(control.truePose(id).at())) {
        operator.drivesOff(control, id);
        return true;
      }
    }
    return false;
  }
}
