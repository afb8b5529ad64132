package org.starl.apps.intersection;

import java.util.Deque;
import java.util.List;
import java.util.function.BiFunction;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Zone;
import org.starl.apps.intersection.robot.Car;
import org.starl.id.Participants;
import org.starl.id.RobotId;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.world.Unsynced;

/**
 * Lets cars arrive at random for a while. A car waits beyond the edge of the road until the last place
 * of its arm is free, and joins the run there. It leaves the run when its program has ended. Cars that
 * are still beyond the edge at the end of arrivals turn away.
 *
 * <p>Restarts a roadside unit that has been dead for a minute.
 */
final class OpenRoad extends Traffic {

  private final Arrivals arrivals;
  private final long untilNs;
  private final Participants units;
  private final BiFunction<Car, Traffic, RobotSpec> robots;
  private final OpenRoadStory story;
  private boolean arrivalsAreOver;

  /**
   * @param untilNs the end of arrivals
   * @param units the roadside units, which stay to the end
   * @param robots creates the robot of a car that enters
   */
  OpenRoad(
      double radiusMm,
      Arrivals arrivals,
      long untilNs,
      Participants units,
      BiFunction<Car, Traffic, RobotSpec> robots,
      OpenRoadStory story) {
    super(radiusMm, List.of());
    this.arrivals = arrivals;
    this.untilNs = untilNs;
    this.units = units;
    this.robots = robots;
    this.story = story;
    for (Zone zone : Zone.values()) {
      queue(Crossing.placeName(zone, 0));
    }
  }

  @Override
  protected boolean update(SimControl control) {
    for (RobotId unit : units) {
      if (isLongDead(control, unit)) {
        control.restart(unit, Unsynced.LOST);
      }
    }
    for (Car car : List.copyOf(cars)) {
      if (control.isFinished(car.id())) {
        remove(control, car);
      }
    }
    arrivals
        .until(control.nowNs())
        .forEach(car -> {
          Deque<Car> queue = queue(car.arm());
          queue.add(car);
          story.arrived(car, queue.size());
        });
    if (!arrivalsAreOver && arrivals.areComplete()) {
      arrivalsAreOver = true;
      story.arrivalsEnded(control.nowNs());
    } else if (!arrivalsAreOver && control.nowNs() >= untilNs) {
      arrivalsAreOver = true;
      queues.values().forEach(queue -> story.turnedAway(queue, control.nowNs()));
      queues.values().forEach(Deque::clear);
    }
    story.towed(towed());
    return arrivalsAreOver;
  }

  @Override
  protected boolean appears(SimControl control, Car car) {
    String edge = car.arm() + "." + (Crossing.PLACES - 1);
    if (!isClear(control, Crossing.region(edge)) || !control.isFree(car.start())) {
      return false;
    }
    cars.add(car);
    control.join(robots.apply(car, this));
    story.entered(car);
    return true;
  }

  @Override
  protected void finish(SimControl control) {
    units.forEach(control::leave);
  }
}
