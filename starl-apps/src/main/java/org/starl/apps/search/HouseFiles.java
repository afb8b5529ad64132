package org.starl.apps.search;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.starl.apps.search.logic.Driving;
import org.starl.apps.search.logic.House;
import org.starl.apps.search.logic.HousePlan;
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * A house in the original StarL's files: {@code obstacles.wpt} with the walls, {@code dest.wpt} with a
 * point in each door, {@code start.wpt} with the robots' poses, {@code senseObjects.wpt} with what is
 * to be found. Rooms are not in them: {@link House} derives them.
 */
final class HouseFiles {

  private final Path folder;
  private final Obstacles walls;
  private final List<Waypoint> doors;
  private final List<Waypoint> starts;
  private final List<Waypoint> things;

  private HouseFiles(Path folder) {
    this.folder = folder;
    walls = WaypointFiles.read(folder.resolve("obstacles.wpt")).obstacles();
    doors = WaypointFiles.read(folder.resolve("dest.wpt")).waypoints();
    starts = WaypointFiles.read(folder.resolve("start.wpt")).waypoints();
    things = WaypointFiles.read(folder.resolve("senseObjects.wpt")).sensePoints();
  }

  /**
   * Reads a folder.
   *
   * @throws BadInput naming file and value, if one is missing or no house comes of them
   */
  static SearchScene read(Path folder, double rangeMm, MotionParameters body) {
    return new HouseFiles(folder).scene(rangeMm, body);
  }

  private SearchScene scene(double rangeMm, MotionParameters body) {
    require(!walls.isEmpty(), "obstacles.wpt", "expected walls, lines Obstacle;x,y;...;-1");
    require(!doors.isEmpty(), "dest.wpt", "expected doors, lines WAY,x,y,angle,name");
    require(!starts.isEmpty(), "start.wpt", "expected robots, lines WAY,x,y,angle,name");
    for (Obstacle wall : walls.all()) {
      require(
          !wall.hidden() && wall.lifetimeMs() == Obstacle.FOREVER,
          "obstacles.wpt",
          "expected walls that are known and stand for ever: by their map robots prove what they"
              + " have seen");
    }
    List<SearchScene.Start> robots = new ArrayList<>();
    for (Waypoint start : starts) {
      require(
          RobotId.isValid(start.name()),
          "start.wpt",
          BadInput.quote(start.name()) + ": expected a robot's name, such as bot0");
      robots.add(new SearchScene.Start(new RobotId(start.name()), start.position().pose()));
    }
    House house;
    try {
      HousePlan plan = plan();
      house = House.of(plan, rangeMm, Driving.clearanceMm(body, plan.bounds()));
    } catch (IllegalArgumentException noHouse) {
      throw new BadInput(folder + ": " + noHouse.getMessage());
    }
    return new SearchScene(house, robots, positions(things));
  }

  private HousePlan plan() {
    List<Point> corners = new ArrayList<>();
    walls.all().forEach(wall -> corners.addAll(wall.points()));
    List<Point> starting = new ArrayList<>();
    positions(starts).forEach(start -> starting.add(start.at()));
    return new HousePlan(Rectangle.around(corners), walls, positions(doors), starting);
  }

  private static List<ItemPosition> positions(List<Waypoint> waypoints) {
    List<ItemPosition> positions = new ArrayList<>();
    waypoints.forEach(waypoint -> positions.add(waypoint.position()));
    return positions;
  }

  private void require(boolean holds, String file, String expected) {
    if (!holds) {
      throw new BadInput(folder.resolve(file) + ": " + expected);
    }
  }
}
