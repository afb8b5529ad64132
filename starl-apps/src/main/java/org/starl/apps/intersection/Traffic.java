package org.starl.apps.intersection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Rectangle;
import org.starl.sim.Director;
import org.starl.sim.SimControl;

/**
 * Moves a fixed set of cars on and off the floor. A car appears in its arrival zone when it is ready
 * and the cars before it have left that zone. It leaves the floor when it has released all its zones
 * and stands at the end of a road.
 */
final class Traffic implements Director {

  private static final long LOOK_EVERY_NS = 100_000_000;

  private final double clearanceMm;
  private final List<Rectangle> exits;
  private final SortedMap<String, Deque<Car>> waiting = new TreeMap<>();
  private final List<Car> cars;
  private final List<Car> onFloor = new ArrayList<>();
  private final Operator operator;
  private boolean isOver;

  Traffic(Crossing crossing, double radiusMm, List<Car> cars, Operator operator) {
    this.cars = List.copyOf(cars);
    this.operator = operator;
    // Between the centres of two cars, one of which has left the arrival zone of the other.
    clearanceMm = 3 * radiusMm;
    exits = Arrays.stream(Zone.values()).map(crossing::exitRegion).toList();
    for (Car car : cars) {
      waiting.computeIfAbsent(car.arm(), arm -> new ArrayDeque<>()).add(car);
    }
  }

  @Override
  public void direct(SimControl control) {
    cars.forEach(car -> operator.checkCar(control, car.id()));
    onFloor.removeIf(
        car -> !control.isOnFloor(car.id()) || operator.takeIfThrough(control, car.id(), exits));
    for (Deque<Car> queue : waiting.values()) {
      Car first = queue.peek();
      if (first != null && first.readyNs() <= control.nowNs() && appears(control, first)) {
        onFloor.add(queue.remove());
      }
    }
    isOver =
        waiting.values().stream().allMatch(Deque::isEmpty)
            && cars.stream().allMatch(car -> control.isFinished(car.id()));
    if (!isOver) {
      control.at(control.nowNs() + LOOK_EVERY_NS, () -> direct(control));
    }
  }

  @Override
  public boolean isOver() {
    return isOver;
  }

  private boolean appears(SimControl control, Car car) {
    for (Car other : onFloor) {
      if (control.truePose(other.id()).distanceMm(car.start().at()) < clearanceMm) {
        return false;
      }
    }
    return control.putOnFloor(car.id());
  }
}
