package org.starl.apps.intersection;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.logic.Zone;
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
  static LegacyFiles read(Path folder) {
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

  private static Trip trip(String robot, List<ItemPosition> points) {
    List<ItemPosition> stations = new ArrayList<>();
    for (ItemPosition point : points) {
      Optional<Zone> zone = Crossing.zoneAt(point.at());
      if (zone.isPresent()) {
        addZone(robot, stations, new ItemPosition(zone.get().name(), point.pose()));
      } else if (endsInCriticalZone(stations)) {
        stations.add(new ItemPosition(last(stations) + "1", point.pose()));
      }
    }
    if (stations.isEmpty() || endsInCriticalZone(stations)) {
      throw new BadInput(robot + ": its waypoints do not lead through the intersection and out");
    }
    String label = "legacy " + String.join(" ", names(stations));
    return new Trip(label, List.of(), stations, points.get(points.size() - 1));
  }

  /** Adds a station, unless the last one is in the same zone. A zone is requested and released once. */
  private static void addZone(String robot, List<ItemPosition> stations, ItemPosition next) {
    if (stations.isEmpty() || !last(stations).equals(next.name())) {
      if (names(stations).contains(next.name())) {
        throw new BadInput(
            robot + ": its waypoints come back to zone " + next.name() + ": expected each once");
      }
      stations.add(next);
    }
  }

  private static boolean endsInCriticalZone(List<ItemPosition> stations) {
    return !stations.isEmpty() && last(stations).length() == 1;
  }

  private static String last(List<ItemPosition> stations) {
    return stations.get(stations.size() - 1).name();
  }

  private static List<String> names(List<ItemPosition> stations) {
    return stations.stream().map(ItemPosition::name).toList();
  }
}
