package org.starl.apps.search;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.Sensing;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.sim.Director;
import org.starl.sim.SimControl;

/**
 * The robots' sensors in the simulator: they show what is in range and sight of the robot's true
 * body, wherever the robot believes to be. A director, since its control knows the bodies; it
 * changes nothing.
 */
final class TrueSensors implements Director {

  private final House house;
  private final List<ItemPosition> things;
  private @Nullable SimControl control;

  TrueSensors(House house, List<ItemPosition> things) {
    this.house = house;
    this.things = List.copyOf(things);
  }

  @Override
  public void direct(SimControl newControl) {
    control = newControl;
  }

  Sensing of(RobotId robot) {
    return () -> {
      if (things.isEmpty() || control == null || !control.isOnFloor(robot)) {
        return List.of();
      }
      Point at = control.truePose(robot).at();
      return things.stream()
          .filter(thing -> at.distanceMm(thing.at()) <= house.rangeMm())
          .filter(thing -> house.sight().sees(at, thing.at()))
          .toList();
    };
  }
}
