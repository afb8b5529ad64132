package org.starl.apps.race;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.starl.apps.race.logic.RacePoint;
import org.starl.body.MotionParameters;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/** The points of a race: the {@code WAY} lines of a file in their order. */
final class RacePoints {

  /** A claim has two bytes for the point's number. */
  private static final int MAX = 1000;

  private RacePoints() {}

  /**
   * @throws BadInput if the file cannot be read or its points cannot be raced to
   */
  static List<RacePoint> read(String file) {
    List<RacePoint> points = new ArrayList<>();
    Set<String> names = new TreeSet<>();
    for (Waypoint waypoint : WaypointFiles.read(Path.of(file)).waypoints()) {
      double radiusMm = waypoint.radiusMm().orElse(MotionParameters.DEFAULT.goalRadiusMm());
      String quoted = BadInput.quote(waypoint.name());
      if (!names.add(waypoint.name())) {
        throw new BadInput(
            file + ": two points are called " + quoted + ": expected different names");
      }
      if (!(radiusMm > 0)) {
        throw new BadInput(file + ": point " + quoted + ": expected a radius above 0");
      }
      points.add(
          new RacePoint(waypoint.name(), new Point(waypoint.xMm(), waypoint.yMm()), radiusMm));
    }
    if (points.isEmpty() || points.size() > MAX) {
      throw new BadInput(
          file + ": has " + points.size() + " points: expected 1 to " + MAX + " WAY lines");
    }
    return points;
  }
}
