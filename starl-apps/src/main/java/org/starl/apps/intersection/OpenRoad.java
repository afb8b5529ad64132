package org.starl.apps.intersection;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.sim.Director;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;

/**
 * Lets cars arrive at random for a while. A car waits beyond the edge of the road until the last place
 * of its arm is free, and enters there. It leaves the floor when it has released everything and stands
 * past its departure zone, and leaves the run when it has unregistered. Cars that are still beyond the
 * edge at the end of arrivals turn away.
 */
final class OpenRoad implements Director {

  private static final long LOOK_EVERY_NS = 100_000_000;

  private final Crossing crossing;
  private final double radiusMm;
  private final Arrivals arrivals;
  private final long untilNs;
  private final Function<Car, RobotSpec> robots;
  private final OpenRoadStory story;
  private final Operator operator;
  private final Participants units;
  private final List<Rectangle> exits;
  private final Map<String, Deque<Car>> beyondEdge = new LinkedHashMap<>();
  private final List<Car> cars = new ArrayList<>();
  private boolean arrivalsAreOver;

  /**
   * @param untilNs the end of arrivals
   * @param robots creates the robot of a car that enters
   * @param units the roadside units, which stay to the end
   */
  OpenRoad(
      Crossing crossing,
      double radiusMm,
      Arrivals arrivals,
      long untilNs,
      Function<Car, RobotSpec> robots,
      OpenRoadStory story,
      Operator operator,
      Participants units) {
    this.crossing = crossing;
    this.radiusMm = radiusMm;
    this.arrivals = arrivals;
    this.untilNs = untilNs;
    this.robots = robots;
    this.story = story;
    this.operator = operator;
    this.units = units;
    exits = Arrays.stream(Zone.values()).map(crossing::exitRegion).toList();
    for (Zone zone : Zone.values()) {
      beyondEdge.put(Crossing.placeName(zone, 0), new ArrayDeque<>());
    }
  }

  @Override
  public boolean isOver() {
    return arrivalsAreOver && cars.isEmpty();
  }

  @Override
  public void direct(SimControl control) {
    long nowNs = control.nowNs();
    units.forEach(unit -> operator.checkUnit(control, unit));
    cars.removeIf(car -> isGone(control, car.id()));
    for (Car next = arrivals.poll(nowNs); next != null; next = arrivals.poll(nowNs)) {
      beyondEdge.computeIfAbsent(next.arm(), arm -> new ArrayDeque<>()).add(next);
      story.arrived(next);
    }
    if (nowNs >= untilNs && !arrivalsAreOver) {
      arrivalsAreOver = true;
      story.turnedAway(beyondEdge.values().stream().mapToInt(Deque::size).sum());
      beyondEdge.values().forEach(Deque::clear);
    }
    for (Deque<Car> queue : beyondEdge.values()) {
      Car first = queue.peek();
      if (first != null && isEdgeFree(control, first)) {
        cars.add(first);
        control.join(robots.apply(first));
        story.entered(queue.remove());
      }
    }
    story.towed(operator.towed());
    if (isOver()) {
      units.forEach(control::leave);
    } else {
      control.at(nowNs + LOOK_EVERY_NS, () -> direct(control));
    }
  }

  private boolean isEdgeFree(SimControl control, Car car) {
    Region edge = crossing.region(car.arm() + "." + (Crossing.PLACES - 1));
    for (Car other : cars) {
      if (other.arm().equals(car.arm())
          && control.isOnFloor(other.id())
          && edge.distanceMm(control.truePose(other.id()).at()) < radiusMm) {
        return false;
      }
    }
    return control.isFree(car.start());
  }

  private boolean isGone(SimControl control, RobotId id) {
    operator.checkCar(control, id);
    operator.takeIfThrough(control, id, exits);
    if (!control.isFinished(id)) {
      return false;
    }
    control.leave(id);
    operator.forget(id);
    return true;
  }
}
