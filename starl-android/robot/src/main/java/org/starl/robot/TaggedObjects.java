package org.starl.robot;

import static org.starl.time.Time.NS_PER_S;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.function.Supplier;
import org.starl.geometry.Fix;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.motion.Location;
import org.starl.platform.Clock;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Sighting;

/**
 * An object sensor made of a position feed: shows the rigid bodies that are no robots, if they are
 * within range of the robot's estimated position, and no known obstacle is on the line between. The
 * measuring system must see a body; one that it has lost counts as standing there for another {@value
 * #LOST_S} s, longer than robots move without fixes.
 */
final class TaggedObjects implements ObjectSensor {

  private static final int LOST_S = 5;

  private final Supplier<SortedMap<String, Fix>> bodies;
  private final Set<String> robots;
  private final Supplier<Location> location;
  private final Obstacles obstacles;
  private final Clock clock;
  private double rangeMm = -1;

  /**
   * @param bodies the newest fix of each rigid body, by its name
   * @param robots the names of the robots' rigid bodies
   * @param location the robot's estimate
   * @param obstacles the robot's map
   * @param clock of the fixes
   */
  TaggedObjects(
      Supplier<SortedMap<String, Fix>> bodies,
      Set<String> robots,
      Supplier<Location> location,
      Obstacles obstacles,
      Clock clock) {
    this.bodies = bodies;
    this.robots = robots;
    this.location = location;
    this.obstacles = obstacles;
    this.clock = clock;
  }

  @Override
  public void require(double newRangeMm) {
    rangeMm = newRangeMm;
  }

  @Override
  public List<Sighting> sensed() {
    if (rangeMm < 0) {
      throw new IllegalStateException("expected require(rangeMm) before sensed()");
    }
    List<Sighting> sensed = new ArrayList<>();
    if (location.get() instanceof Location.Known here) {
      long oldestNs = clock.nowNs() - LOST_S * NS_PER_S;
      for (Map.Entry<String, Fix> body : bodies.get().entrySet()) {
        Fix fix = body.getValue();
        if (!robots.contains(body.getKey())
            && fix.timeNs() >= oldestNs
            && isInView(here.pose().at(), fix.pose().at())) {
          sensed.add(new Sighting(body.getKey(), fix.pose().at(), fix.errorMm()));
        }
      }
    }
    return sensed;
  }

  private boolean isInView(Point from, Point object) {
    return from.distanceMm(object) <= rangeMm && !obstacles.hide(from, object);
  }
}
