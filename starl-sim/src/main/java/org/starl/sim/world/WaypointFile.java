package org.starl.sim.world;

import java.util.List;
import org.starl.geometry.Obstacles;

/**
 * The content of a waypoint file, in the order of its lines.
 *
 * @param waypoints lines {@code WAY}: goals or starts
 * @param sensePoints lines {@code SENSE}: objects to find
 * @param obstacles lines {@code Obstacle} and {@code Hidden}
 */
public record WaypointFile(
    List<Waypoint> waypoints, List<Waypoint> sensePoints, Obstacles obstacles) {

  public static final WaypointFile EMPTY = new WaypointFile(List.of(), List.of(), Obstacles.NONE);

  public WaypointFile {
    waypoints = List.copyOf(waypoints);
    sensePoints = List.copyOf(sensePoints);
  }
}
