package org.starl.apps.intersection;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.apps.intersection.logic.CrossingTrace;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.id.RobotId;
import org.starl.sim.SimControl;
import org.starl.sim.SimObserver;
import org.starl.sim.world.Unsynced;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Variable;

/**
 * Takes cars off the floor: those that have crossed and given back all that they held, and those whose
 * program has been dead for a minute. On such a car, and on one whose program dies when it is off the
 * floor already, another program is started, which says that the car is nowhere any more. A roadside
 * unit that has been dead for a minute is started again.
 */
final class Operator implements SimObserver {

  private static final long TOW_AFTER_NS = 60_000_000_000L;

  private final Set<RobotId> ready = new TreeSet<>();
  private final Set<RobotId> offFloor = new TreeSet<>();
  private final Map<RobotId, Long> deadSinceNs = new TreeMap<>();
  private int towed;

  @Override
  public void observed(TraceEvent event) {
    if (event instanceof Variable variable
        && variable.source().equals(CrossingTrace.SOURCE)
        && variable.name().equals(CrossingTrace.LOCATION)) {
      Location location = Location.valueOf(variable.value());
      if (location == Location.UNREGISTER_WAIT || location == Location.DONE) {
        ready.add(variable.robot());
      } else {
        ready.remove(variable.robot());
      }
    }
  }

  /** Whether a car has given back all that it held, as its program has told. */
  boolean isReady(RobotId car) {
    return ready.contains(car);
  }

  /** A car that has crossed drives off the floor. */
  void drivesOff(SimControl control, RobotId car) {
    offFloor.add(car);
    control.takeOffFloor(car);
  }

  /** Looks after a car that is there; to be called now and then. */
  void look(SimControl control, RobotId car) {
    if (isLongDead(control, car)) {
      if (control.isOnFloor(car)) {
        towed++;
        drivesOff(control, car);
      }
      control.restart(car, Unsynced.LOST);
    }
  }

  /** The same for a roadside unit, which is started again where it stands. */
  void lookAtUnit(SimControl control, RobotId unit) {
    if (isLongDead(control, unit)) {
      control.restart(unit, Unsynced.LOST);
    }
  }

  private boolean isLongDead(SimControl control, RobotId robot) {
    if (control.isUp(robot)) {
      deadSinceNs.remove(robot);
      return false;
    }
    long nowNs = control.nowNs();
    Long sinceNs = deadSinceNs.putIfAbsent(robot, nowNs);
    boolean isLong = sinceNs != null && nowNs - sinceNs >= TOW_AFTER_NS;
    if (isLong) {
      deadSinceNs.remove(robot);
    }
    return isLong;
  }

  /** Whether a program that starts on {@code car} now starts off the floor, where the car has been. */
  boolean isOffFloor(RobotId car) {
    return offFloor.contains(car);
  }

  /** A car is out of the run. */
  void forget(RobotId car) {
    ready.remove(car);
    offFloor.remove(car);
    deadSinceNs.remove(car);
  }

  /** How many cars it has towed. */
  int towed() {
    return towed;
  }
}
