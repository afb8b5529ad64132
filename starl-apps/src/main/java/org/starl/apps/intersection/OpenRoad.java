package org.starl.apps.intersection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Region;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.sim.Director;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;

/**
 * Cars arrive at random for a while. One that arrives comes onto the road at the last place of its
 * arm once nobody is in that place, and waits beyond the edge until then. One that has come to a
 * stand past its departure zone, and has given back all that it held, drives off the floor, and is
 * out of the run when it has unregistered. Whoever still waits beyond the edge when the time of
 * arrivals is over turns away.
 */
final class OpenRoad implements Director {

  private static final long LOOK_EVERY_NS = 100_000_000;
  private static final int EDGE = Crossing.PLACES - 1;

  private final Crossing crossing;
  private final double radiusMm;
  private final Arrivals arrivals;
  private final long untilNs;
  private final BiFunction<Arrival, Trip, RobotSpec> programs;
  private final OpenRoadStory story;
  private final Operator operator;
  private final Participants units;
  private final Map<Zone, Deque<Arrival>> outside = new EnumMap<>(Zone.class);
  private final List<Car> cars = new ArrayList<>();
  private boolean arrivalsAreOver;

  private record Car(RobotId id, Zone arm, Region exit) {}

  /**
   * @param untilNs the end of arrivals
   * @param programs makes the robot of an arrival
   * @param units at the roadside, which are there from the start to the end
   */
  OpenRoad(
      Crossing crossing,
      double radiusMm,
      Arrivals arrivals,
      long untilNs,
      BiFunction<Arrival, Trip, RobotSpec> programs,
      OpenRoadStory story,
      Operator operator,
      Participants units) {
    this.crossing = crossing;
    this.radiusMm = radiusMm;
    this.arrivals = arrivals;
    this.untilNs = untilNs;
    this.programs = programs;
    this.story = story;
    this.operator = operator;
    this.units = units;
  }

  @Override
  public boolean isOver() {
    return arrivalsAreOver && cars.isEmpty();
  }

  @Override
  public void direct(SimControl control) {
    look(control);
  }

  private void look(SimControl control) {
    long nowNs = control.nowNs();
    units.forEach(unit -> operator.lookAtUnit(control, unit));
    cars.removeIf(car -> isGone(control, car));
    for (Arrival next = arrivals.poll(nowNs); next != null; next = arrivals.poll(nowNs)) {
      outside.computeIfAbsent(next.route().from(), arm -> new ArrayDeque<>()).add(next);
      story.arrived(next);
    }
    if (nowNs >= untilNs && !arrivalsAreOver) {
      arrivalsAreOver = true;
      outside
          .values()
          .forEach(waiting -> {
            story.turnedAway(waiting.size());
            waiting.clear();
          });
    }
    for (Deque<Arrival> waiting : outside.values()) {
      if (!waiting.isEmpty() && comesIn(control, waiting.element())) {
        story.cameIn(waiting.remove());
      }
    }
    story.towed(operator.towed());
    if (!isOver()) {
      control.at(nowNs + LOOK_EVERY_NS, () -> look(control));
    } else {
      units.forEach(control::leave);
    }
  }

  private boolean comesIn(SimControl control, Arrival arrival) {
    Zone arm = arrival.route().from();
    Region edge = crossing.place(arm, EDGE);
    for (Car car : cars) {
      if (car.arm() == arm
          && control.isOnFloor(car.id())
          && edge.distanceMm(control.truePose(car.id()).at()) < radiusMm) {
        return false;
      }
    }
    if (!control.isFree(crossing.placePose(arm, EDGE))) {
      return false;
    }
    Trip trip = crossing.tripFromEdge(arrival.route());
    cars.add(new Car(arrival.id(), arm, crossing.exitRegion(arrival.route().lastZone())));
    control.join(programs.apply(arrival, trip));
    return true;
  }

  private boolean isGone(SimControl control, Car car) {
    RobotId id = car.id();
    operator.look(control, id);
    if (control.isOnFloor(id)
        && operator.isReady(id)
        && car.exit().contains(control.truePose(id).at())) {
      operator.drivesOff(control, id);
    }
    if (!control.isFinished(id)) {
      return false;
    }
    control.leave(id);
    operator.forget(id);
    return true;
  }
}
