package org.starl.apps.intersection;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.logic.Zone;
import org.starl.apps.intersection.robot.Car;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * The original StarL's intersection: {@code start.wpt} with the robots' poses, {@code dest.wpt} with
 * their waypoints (the angle column is the robot's number) and {@code obstacles.wpt}.
 *
 * <p>Those waypoints are not routes of the paper: robot 0 drives through all four zones and makes a
 * U-turn, and robot 4 has no waypoint and stays parked. Here each zone on a robot's way becomes a
 * station, as does the first waypoint behind the zones; the last waypoint is the exit.
 */
record LegacyFiles(List<Car> cars, Obstacles obstacles) {

  /**
   * @throws BadInput if a file is missing, or a robot's waypoints are not a way through the crossing
   */
  static LegacyFiles read(String path) {
    if (path.isEmpty()) {
      throw new BadInput("files='': expected the folder of the original's .wpt files");
    }
    Path folder = Path.of(path);
    List<Waypoint> goals = WaypointFiles.read(folder.resolve("dest.wpt")).waypoints();
    List<Car> cars = new ArrayList<>();
    for (Waypoint start : WaypointFiles.read(folder.resolve("start.wpt")).waypoints()) {
      String name = start.name();
      if (!RobotId.isValid(name)) {
        throw new BadInput(
            "start.wpt: " + BadInput.quote(name) + ": expected a robot's name, such as bot0");
      }
      int number = cars.size();
      List<ItemPosition> points =
          goals.stream().filter(g -> g.angle() == number).map(Waypoint::position).toList();
      Trip trip = points.isEmpty() ? Trip.parked(start.position()) : trip(name, points);
      cars.add(new Car(new RobotId(name), name, start.position().pose(), trip, 0));
    }
    return new LegacyFiles(cars, WaypointFiles.read(folder.resolve("obstacles.wpt")).obstacles());
  }

  /** The stations of a trip; a zone is requested and released once. */
  private static Trip trip(String robot, List<ItemPosition> points) {
    Map<String, ItemPosition> stations = new LinkedHashMap<>();
    String last = "";
    for (ItemPosition point : points) {
      Optional<Zone> zone = Crossing.zoneAt(point.at());
      boolean isBehindZone = zone.isEmpty() && last.length() == 1;
      String name = isBehindZone ? last + "1" : zone.map(Zone::name).orElse(last);
      if (!name.equals(last)) {
        if (stations.put(name, new ItemPosition(name, point.pose())) != null) {
          throw new BadInput(
              robot + ": its waypoints enter zone " + name + " again: expected each zone once");
        }
        last = name;
      }
    }
    if (last.length() <= 1) {
      throw new BadInput(robot + ": its waypoints do not lead through the intersection and out");
    }
    String label = "legacy " + String.join(" ", stations.keySet());
    ItemPosition exit = points.get(points.size() - 1);
    return new Trip(label, Optional.empty(), List.of(), List.copyOf(stations.values()), exit);
  }
}
