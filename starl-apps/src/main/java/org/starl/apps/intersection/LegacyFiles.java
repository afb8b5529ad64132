package org.starl.apps.intersection;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.Trip;
import org.starl.apps.intersection.logic.Zone;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFile;
import org.starl.sim.world.WaypointFiles;

/**
 * The original StarL's own intersection: {@code start.wpt} with the robots' poses, {@code dest.wpt}
 * with their waypoints (the angle column is the robot's number) and {@code obstacles.wpt}.
 *
 * <p>Those waypoints are no routes of the paper: robot 0 drives through all four zones and back
 * where it came from, a U-turn, and robot 4 has no waypoint at all and stays parked. What counts
 * here is which zones a robot drives through: each becomes a station, as does the first waypoint
 * behind them; the last waypoint is the exit.
 */
final class LegacyFiles {

  private final Crossing crossing;
  private final WaypointFile starts;
  private final WaypointFile destinations;
  private final Obstacles obstacles;

  private LegacyFiles(
      Crossing crossing, WaypointFile starts, WaypointFile destinations, Obstacles obstacles) {
    this.crossing = crossing;
    this.starts = starts;
    this.destinations = destinations;
    this.obstacles = obstacles;
  }

  static LegacyFiles read(Path folder, Crossing crossing) {
    return new LegacyFiles(
        crossing,
        WaypointFiles.read(folder.resolve("start.wpt")),
        WaypointFiles.read(folder.resolve("dest.wpt")),
        WaypointFiles.read(folder.resolve("obstacles.wpt")).obstacles());
  }

  Obstacles obstacles() {
    return obstacles;
  }

  List<Car> cars() {
    List<Car> cars = new ArrayList<>();
    for (Waypoint start : starts.waypoints()) {
      int number = cars.size();
      List<ItemPosition> points = waypointsOf(number);
      Trip trip = points.isEmpty() ? Trip.parked(start.position()) : trip(start.name(), points);
      if (!RobotId.isValid(start.name())) {
        throw new BadInput(
            "start.wpt: "
                + BadInput.quote(start.name())
                + ": expected a robot's name, such as bot0");
      }
      RobotId id = new RobotId(start.name());
      cars.add(new Car(id, id.name(), start.position().pose(), trip, 0));
    }
    return cars;
  }

  private List<ItemPosition> waypointsOf(int robot) {
    List<ItemPosition> points = new ArrayList<>();
    for (Waypoint waypoint : destinations.waypoints()) {
      if (waypoint.angle() == robot) {
        points.add(waypoint.position());
      }
    }
    return points;
  }

  private Trip trip(String robot, List<ItemPosition> points) {
    List<ItemPosition> stations = new ArrayList<>();
    for (ItemPosition point : points) {
      Zone critical = criticalZone(point);
      if (critical != null) {
        addZone(robot, stations, new ItemPosition(critical.name(), point.pose()));
      } else if (!stations.isEmpty()) {
        String last = stations.get(stations.size() - 1).name();
        if (last.length() == 1) {
          stations.add(new ItemPosition(last + "1", point.pose()));
        }
      }
    }
    if (stations.isEmpty() || stations.get(stations.size() - 1).name().length() == 1) {
      throw new BadInput(robot + ": its waypoints do not lead through the intersection and out");
    }
    StringBuilder label = new StringBuilder("legacy");
    stations.forEach(station -> label.append(' ').append(station.name()));
    return new Trip(label.toString(), stations, points.get(points.size() - 1));
  }

  /** A zone is asked for once and given back once: several waypoints in it are one station. */
  private static void addZone(String robot, List<ItemPosition> stations, ItemPosition next) {
    for (int i = 0; i < stations.size(); i++) {
      if (stations.get(i).name().equals(next.name())) {
        if (i < stations.size() - 1) {
          throw new BadInput(
              robot + ": its waypoints come back to zone " + next.name() + ": expected each once");
        }
        return;
      }
    }
    stations.add(next);
  }

  private @Nullable Zone criticalZone(ItemPosition point) {
    for (Zone zone : Zone.values()) {
      if (crossing.region(zone).contains(point.at())) {
        return zone;
      }
    }
    return null;
  }
}
