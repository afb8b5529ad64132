package org.starl.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Sighting;

/**
 * The object sensor of a simulated robot: shows what is in range and sight of its true body,
 * without errors. Robots' bodies hide nothing.
 */
public final class SimObjects implements ObjectSensor {

  private final FloorObjects floor;
  private final World world;
  private final Supplier<@Nullable Body> body;
  private double rangeMm = -1;

  private SimObjects(FloorObjects floor, World world, Supplier<@Nullable Body> body) {
    this.floor = floor;
    this.world = world;
    this.body = body;
  }

  /**
   * @param floor null if the scenario gives its robots no sensors
   * @param body the robot's; null while it is off the floor
   */
  public static ObjectSensor of(
      @Nullable FloorObjects floor, World world, Supplier<@Nullable Body> body) {
    return floor == null ? NONE : new SimObjects(floor, world, body);
  }

  @Override
  public void require(double newRangeMm) {
    if (newRangeMm > floor.rangeMm()) {
      throw new IllegalStateException(
          "object sensors with a range of %s mm: expected at least %s mm"
              .formatted(Math.round(floor.rangeMm()), Math.round(newRangeMm)));
    }
    rangeMm = newRangeMm;
  }

  @Override
  public List<Sighting> sensed() {
    if (rangeMm < 0) {
      throw new IllegalStateException("expected require(rangeMm) before sensed()");
    }
    Body here = body.get();
    List<Sighting> sensed = new ArrayList<>();
    if (here == null || floor.objects().isEmpty()) {
      return sensed;
    }
    Point at = here.pose().at();
    Obstacles standing = world.obstacles().standingAt(world.nowNs());
    for (ItemPosition object : floor.objects()) {
      boolean isNear = at.distanceMm(object.at()) <= rangeMm;
      if (isNear && !standing.hide(at, object.at())) {
        sensed.add(new Sighting(object.name(), object.at(), 0));
      }
    }
    return sensed;
  }
}
