package org.starl.sim;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.world.Placement;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/** Start poses of robots: from a file, or drawn by seed. */
final class Starts {

  private Starts() {}

  static List<Pose> of(SimSettings settings, int robots, Obstacles obstacles, Rng rng) {
    String file = settings.get(Setting.START_FILE);
    return file.isEmpty()
        ? drawn(settings, robots, obstacles, rng)
        : fromFile(file, settings.robotName(), robots);
  }

  private static List<Pose> drawn(SimSettings settings, int robots, Obstacles obstacles, Rng rng) {
    double radiusMm = settings.robotRadiusMm();
    Placement placement =
        new Placement(
            settings.get(Setting.FLOOR_WIDTH),
            settings.get(Setting.FLOOR_HEIGHT),
            radiusMm,
            settings.get(Setting.START_SPACING) * radiusMm,
            obstacles);
    return placement.draw(robots, rng.fork("placement"));
  }

  private static List<Pose> fromFile(String file, String robotName, int robots) {
    Map<String, Pose> byName = new TreeMap<>();
    for (Waypoint waypoint : WaypointFiles.read(Path.of(file)).waypoints()) {
      byName.put(waypoint.name(), waypoint.position().pose());
    }
    List<Pose> starts = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      Pose start = byName.get(robotName + i);
      if (start == null) {
        throw new BadInput(
            file
                + ": has no start of "
                + robotName
                + i
                + ": expected a line WAY,x,y,angle,"
                + robotName
                + i);
      }
      starts.add(start);
    }
    return starts;
  }
}
