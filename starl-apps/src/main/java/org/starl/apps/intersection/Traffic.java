package org.starl.apps.intersection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.apps.intersection.logic.Zone;
import org.starl.apps.intersection.robot.Car;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.sim.Director;
import org.starl.sim.SimControl;
import org.starl.sim.SimObserver;
import org.starl.sim.world.Unsynced;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/**
 * Moves cars on and off the floor: here a fixed set of cars, on an {@link OpenRoad} cars that join and
 * leave the run. A car appears when it is ready, the cars before it on its arm have appeared, and its
 * place is free. It leaves the floor when it has released everything and stands in an exit.
 *
 * <p>Tows a car whose program has been dead for a minute: takes the car off the floor and restarts the
 * program. The program of a car off the floor has to be a {@link
 * org.starl.apps.intersection.logic.TowedCar}: see {@link #isOffFloor}.
 */
class Traffic implements Director, SimObserver {

  private static final long LOOK_EVERY_NS = 100 * Time.NS_PER_MS;
  private static final long TOW_AFTER_NS = 60 * Time.NS_PER_S;

  protected final double radiusMm;

  /** The cars that have not appeared, by arm. */
  protected final Map<String, Deque<Car>> queues = new LinkedHashMap<>();

  /** The cars in the run. */
  protected final List<Car> cars;

  private final List<? extends Region> exits;
  private final Set<RobotId> ready = new TreeSet<>();
  private final Set<RobotId> offFloor = new TreeSet<>();
  private final Map<RobotId, Long> deadSinceNs = new TreeMap<>();
  private int towed;
  private boolean isOver;

  /**
   * @param cars in the run from the start
   */
  Traffic(double radiusMm, List<Car> cars) {
    this.radiusMm = radiusMm;
    this.cars = new ArrayList<>(cars);
    exits = Arrays.stream(Zone.values()).map(Crossing::exitRegion).toList();
    cars.stream().map(Car::arm).sorted().forEach(this::queue);
    cars.forEach(car -> queue(car.arm()).add(car));
  }

  protected final Deque<Car> queue(String arm) {
    return queues.computeIfAbsent(arm, any -> new ArrayDeque<>());
  }

  @Override
  public final void observed(TraceEvent event) {
    CrossingFact.location(event)
        .ifPresent(location -> {
          if (location == Location.UNREGISTER_WAIT || location == Location.DONE) {
            ready.add(event.robot());
          } else {
            ready.remove(event.robot());
          }
        });
  }

  @Override
  public final void direct(SimControl control) {
    cars.forEach(car -> towIfLongDead(control, car.id()));
    cars.forEach(car -> takeIfThrough(control, car.id()));
    boolean isLast = update(control);
    for (Deque<Car> queue : queues.values()) {
      Car first = queue.peek();
      if (first != null && first.readyNs() <= control.nowNs() && appears(control, first)) {
        queue.remove();
      }
    }
    isOver = isLast && areAllFinished(control);
    if (isOver) {
      finish(control);
    } else {
      control.at(control.nowNs() + LOOK_EVERY_NS, () -> direct(control));
    }
  }

  private boolean areAllFinished(SimControl control) {
    for (Deque<Car> queue : queues.values()) {
      if (!queue.isEmpty()) {
        return false;
      }
    }
    for (Car car : cars) {
      if (!control.isFinished(car.id())) {
        return false;
      }
    }
    return true;
  }

  @Override
  public final boolean isOver() {
    return isOver;
  }

  /**
   * Lets cars join the queues and leave the run.
   *
   * @return whether no more cars will join
   */
  protected boolean update(SimControl control) {
    return true;
  }

  /** Puts a car on the floor, if its place is free; returns whether it did. */
  protected boolean appears(SimControl control, Car car) {
    // So that the other car has left the arrival zone.
    return isClear(control, new Circle(car.start().at(), 2 * radiusMm))
        && control.putOnFloor(car.id());
  }

  /** All cars have left. */
  protected void finish(SimControl control) {}

  /** Whether no car's body is in {@code place}. */
  protected final boolean isClear(SimControl control, Region place) {
    return cars.stream()
        .filter(car -> control.isOnFloor(car.id()))
        .noneMatch(car -> place.distanceMm(control.truePose(car.id()).at()) < radiusMm);
  }

  private void takeIfThrough(SimControl control, RobotId car) {
    if (control.isOnFloor(car) && ready.contains(car)) {
      Point at = control.truePose(car).at();
      if (exits.stream().anyMatch(exit -> exit.contains(at))) {
        takeOffFloor(control, car);
      }
    }
  }

  private void towIfLongDead(SimControl control, RobotId car) {
    if (isLongDead(control, car)) {
      if (control.isOnFloor(car)) {
        towed++;
        takeOffFloor(control, car);
      }
      control.restart(car, Unsynced.LOST);
    }
  }

  private void takeOffFloor(SimControl control, RobotId car) {
    offFloor.add(car);
    control.takeOffFloor(car);
  }

  /** Whether a robot has been dead for a minute; call it at regular intervals. */
  protected final boolean isLongDead(SimControl control, RobotId robot) {
    if (control.isUp(robot)) {
      deadSinceNs.remove(robot);
      return false;
    }
    long sinceNs = deadSinceNs.computeIfAbsent(robot, any -> control.nowNs());
    return control.nowNs() - sinceNs >= TOW_AFTER_NS;
  }

  /** Whether {@code car} has been on the floor and was taken off it. */
  final boolean isOffFloor(RobotId car) {
    return offFloor.contains(car);
  }

  /** Number of cars towed so far. */
  protected final int towed() {
    return towed;
  }

  /** Removes a car from the run. */
  protected final void remove(SimControl control, Car car) {
    cars.remove(car);
    control.leave(car.id());
    ready.remove(car.id());
    offFloor.remove(car.id());
    deadSinceNs.remove(car.id());
  }
}
