package org.starl.apps.intersection;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.sim.SimControl;
import org.starl.sim.SimObserver;
import org.starl.sim.world.Unsynced;
import org.starl.trace.TraceEvent;

/**
 * Takes cars off the floor: cars that have crossed and released all that they held, and cars whose
 * program has been dead for a minute. Restarts the programs of such dead cars, and of roadside units
 * that have been dead for a minute. A program that is started for a car off the floor has to be a
 * {@link org.starl.apps.intersection.logic.TowedCar}: see {@link #isOffFloor}.
 */
final class Operator implements SimObserver {

  private static final long TOW_AFTER_NS = 60_000_000_000L;

  private final Set<RobotId> ready = new TreeSet<>();
  private final Set<RobotId> offFloor = new TreeSet<>();
  private final Map<RobotId, Long> deadSinceNs = new TreeMap<>();
  private int towed;

  @Override
  public void observed(TraceEvent event) {
    CrossingTrace.location(event)
        .ifPresent(location -> {
          if (location == Location.UNREGISTER_WAIT || location == Location.DONE) {
            ready.add(event.robot());
          } else {
            ready.remove(event.robot());
          }
        });
  }

  /**
   * Takes a car off the floor if its program has released everything and it stands in an exit.
   *
   * @return whether it did
   */
  boolean takeIfThrough(SimControl control, RobotId car, Iterable<? extends Region> exits) {
    if (control.isOnFloor(car) && ready.contains(car)) {
      for (Region exit : exits) {
        if (exit.contains(control.truePose(car).at())) {
          takeOffFloor(control, car);
          return true;
        }
      }
    }
    return false;
  }

  private void takeOffFloor(SimControl control, RobotId car) {
    offFloor.add(car);
    control.takeOffFloor(car);
  }

  /** Tows and restarts a car that has been dead for long; call it at regular intervals. */
  void checkCar(SimControl control, RobotId car) {
    if (isLongDead(control, car)) {
      if (control.isOnFloor(car)) {
        towed++;
        takeOffFloor(control, car);
      }
      control.restart(car, Unsynced.LOST);
    }
  }

  /** Restarts a roadside unit that has been dead for long; call it at regular intervals. */
  void checkUnit(SimControl control, RobotId unit) {
    if (isLongDead(control, unit)) {
      control.restart(unit, Unsynced.LOST);
    }
  }

  private boolean isLongDead(SimControl control, RobotId robot) {
    if (control.isUp(robot)) {
      deadSinceNs.remove(robot);
      return false;
    }
    Long sinceNs = deadSinceNs.putIfAbsent(robot, control.nowNs());
    boolean isLong = sinceNs != null && control.nowNs() - sinceNs >= TOW_AFTER_NS;
    if (isLong) {
      deadSinceNs.remove(robot);
    }
    return isLong;
  }

  /** Whether {@code car} has been on the floor and was taken off it. */
  boolean isOffFloor(RobotId car) {
    return offFloor.contains(car);
  }

  /** Forgets a car that is out of the run. */
  void forget(RobotId car) {
    ready.remove(car);
    offFloor.remove(car);
    deadSinceNs.remove(car);
  }

  /** Number of cars towed so far. */
  int towed() {
    return towed;
  }
}
