package org.starl.apps.search;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.apps.search.logic.Drive;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * A house in the files of the original StarL: {@code obstacles.wpt} has the walls, {@code dest.wpt}
 * a point in each door, {@code start.wpt} the robots' poses, {@code senseObjects.wpt} the things to
 * find. They have no rooms: {@link House} derives them.
 */
final class HouseFiles {

  private static final String WALLS = "obstacles.wpt";
  private static final String DOORS = "dest.wpt";
  private static final String STARTS = "start.wpt";
  private static final String THINGS = "senseObjects.wpt";

  private final Path folder;

  private HouseFiles(Path folder) {
    this.folder = folder;
  }

  /**
   * Reads a folder.
   *
   * @throws BadInput naming file and value, if a file is missing or no house can be derived
   */
  static SearchScene read(Path folder, double rangeMm, MotionParameters body) {
    return new HouseFiles(folder).scene(rangeMm, body);
  }

  private SearchScene scene(double rangeMm, MotionParameters body) {
    Obstacles walls = WaypointFiles.read(folder.resolve(WALLS)).obstacles();
    List<Waypoint> doors = WaypointFiles.read(folder.resolve(DOORS)).waypoints();
    List<Waypoint> robots = WaypointFiles.read(folder.resolve(STARTS)).waypoints();
    List<Waypoint> things = WaypointFiles.read(folder.resolve(THINGS)).sensePoints();
    require(!walls.isEmpty(), WALLS, "expected walls, lines Obstacle;x,y;...;-1");
    require(!doors.isEmpty(), DOORS, "expected doors, lines WAY,x,y,angle,name");
    require(!robots.isEmpty(), STARTS, "expected robots, lines WAY,x,y,angle,name");
    for (Obstacle wall : walls.all()) {
      require(
          !wall.hidden() && wall.lifetimeMs() == Obstacle.FOREVER,
          WALLS,
          "expected walls that are known and stand for ever: robots prove by their map what they"
              + " have seen");
    }
    Map<RobotId, Pose> starts = new LinkedHashMap<>();
    for (Waypoint robot : robots) {
      require(
          RobotId.isValid(robot.name()),
          STARTS,
          BadInput.quote(robot.name()) + ": expected a robot's name, such as bot0");
      boolean isNew = starts.put(new RobotId(robot.name()), robot.position().pose()) == null;
      require(isNew, STARTS, "has two robots " + BadInput.quote(robot.name()));
    }
    List<Point> corners = walls.all().stream().flatMap(wall -> wall.points().stream()).toList();
    List<Point> places = positions(robots).stream().map(ItemPosition::at).toList();
    HousePlan plan = new HousePlan(Rectangle.around(corners), walls, positions(doors), places);
    try {
      House house = House.of(plan, rangeMm, Drive.clearanceMm(body, plan.bounds()));
      return new SearchScene(house, starts, positions(things));
    } catch (IllegalArgumentException noHouse) {
      throw new BadInput(folder + ": " + noHouse.getMessage());
    }
  }

  private static List<ItemPosition> positions(List<Waypoint> waypoints) {
    return waypoints.stream().map(Waypoint::position).toList();
  }

  private void require(boolean holds, String file, String expected) {
    if (!holds) {
      throw new BadInput(folder.resolve(file) + ": " + expected);
    }
  }
}
