package org.starl.sim;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.RobotApp;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.world.Placement;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * The initial robots with their start poses: given by the scenario; and of {@code placed} robots
 * from a file, or drawn by seed.
 *
 * @param given by the scenario
 * @param placed number of robots without given poses
 * @param app of the placed robots; null if there are none
 */
record Starts(
    SimSettings settings,
    List<RobotSpec> given,
    int placed,
    @Nullable Function<GlobalVarHolder, ? extends RobotApp> app,
    Obstacles obstacles,
    Rng rng) {

  /** Whether starts are drawn. */
  boolean areDrawn() {
    return placed > 0 && file().isEmpty();
  }

  private String file() {
    return settings.get(Setting.START_FILE);
  }

  /** All robots, with drawn starts as far apart as the settings say. */
  List<RobotSpec> initial() {
    return file().isEmpty()
        ? spaced(
            settings.get(Setting.START_SPACING) * settings.robotRadiusMm(),
            settings.robotRadiusMm())
        : robots(fromFile());
  }

  /**
   * All robots, with drawn starts at least {@code spacingMm} apart and {@code clearanceMm} from
   * edges and obstacles.
   */
  List<RobotSpec> spaced(double spacingMm, double clearanceMm) {
    List<Point> taken = new ArrayList<>();
    given.forEach(robot -> {
      if (robot.onFloor()) {
        taken.add(robot.start().at());
      }
    });
    Placement placement =
        new Placement(
            settings.get(Setting.FLOOR_WIDTH),
            settings.get(Setting.FLOOR_HEIGHT),
            clearanceMm,
            spacingMm,
            obstacles,
            taken);
    return robots(placement.draw(placed, rng.fork("placement")));
  }

  private List<RobotSpec> robots(List<Pose> starts) {
    List<RobotSpec> robots = new ArrayList<>(given);
    for (int i = 0; i < placed && app != null; i++) {
      robots.add(new RobotSpec(new RobotId(settings.robotName() + i), starts.get(i), true, app));
    }
    return robots;
  }

  /**
   * Checks that bodies overlap neither each other nor obstacles.
   *
   * @throws BadInput naming two robots, their distance and the least one
   */
  void check(List<RobotSpec> robots) {
    if (!settings.worldLimits().collisions()) {
      return;
    }
    double radiusMm = settings.robotRadiusMm();
    StartPair nearest = StartPair.nearest(robots);
    if (nearest != null && nearest.mm() < 2 * radiusMm) {
      throw new BadInput(
          nearest + ": expected at least %.0f mm, twice robotRadius".formatted(2 * radiusMm));
    }
    for (RobotSpec robot : robots) {
      double mm = obstacles.distanceMm(robot.start().at());
      if (robot.onFloor() && mm < radiusMm) {
        throw new BadInput(
            "%s starts %.0f mm from an obstacle: expected at least %.0f mm, robotRadius"
                .formatted(robot.id(), mm, radiusMm));
      }
    }
  }

  private List<Pose> fromFile() {
    String file = file();
    Map<String, Pose> byName = new TreeMap<>();
    for (Waypoint waypoint : WaypointFiles.read(Path.of(file)).waypoints()) {
      byName.put(waypoint.name(), waypoint.position().pose());
    }
    List<Pose> starts = new ArrayList<>();
    for (int i = 0; i < placed; i++) {
      String name = settings.robotName() + i;
      Pose start = byName.get(name);
      if (start == null) {
        throw new BadInput(
            file + ": has no start of " + name + ": expected a line WAY,x,y,angle," + name);
      }
      starts.add(start);
    }
    return starts;
  }
}
