package org.starl.apps.maze;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.starl.apps.maze.logic.CollisionMode;
import org.starl.apps.maze.logic.Goal;
import org.starl.apps.maze.logic.MazeTask;
import org.starl.apps.maze.robot.Layout;
import org.starl.apps.maze.robot.Places;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * The original StarL's files: {@code dest.wpt} with the goals, which are dealt to the robots in
 * turn, {@code obstacles.wpt}, and optionally {@code start.wpt} with the robots' poses. Without it
 * starts are drawn so that every goal that can be reached can be reached past the other robots.
 */
record FileMaze(Rectangle floor, Obstacles obstacles, List<Goal> goals, double bodyMm) {

  private static final double TOLERANCE_MM = 20;
  private static final int TRIES = 2_000;
  private static final int ROUNDS = 50;

  // A planner needs a little more room than the margin.
  private static final double SPARE_MM = 10;

  static Layout read(Path folder, Rectangle floor, int robots, double bodyMm, Rng rng) {
    Path dest = folder.resolve("dest.wpt");
    List<Goal> goals = new ArrayList<>();
    for (Waypoint goal : places(dest, floor)) {
      double toleranceMm = Math.max(1, goal.radiusMm().orElse(TOLERANCE_MM));
      goals.add(new Goal(goal.name(), goal.position().at(), toleranceMm));
    }
    if (goals.isEmpty()) {
      throw new BadInput(dest + ": no goal: expected a line WAY,x,y,angle,name[,radius]");
    }
    FileMaze maze = new FileMaze(floor, walls(folder.resolve("obstacles.wpt")), goals, bodyMm);
    Path file = folder.resolve("start.wpt");
    if (Files.exists(file)) {
      List<Waypoint> starts = places(file, floor);
      if (starts.size() < robots) {
        throw new BadInput(file + ": " + starts.size() + " starts: expected " + robots);
      }
      return maze.layout(
          starts.stream().limit(robots).map(start -> start.position().pose()).toList());
    }
    for (int i = 0; i < ROUNDS; i++) {
      Layout layout = maze.layout(maze.drawStarts(robots, rng));
      if (robots == 1 || maze.isFreeOfBlocking(layout)) {
        return layout;
      }
    }
    throw new BadInput(
        "robots: " + robots + ": expected fewer, because some would block the only way of others");
  }

  /** The places in a file, all of which must be on the floor. */
  private static List<Waypoint> places(Path file, Rectangle floor) {
    List<Waypoint> places = WaypointFiles.read(file).waypoints();
    for (Waypoint place : places) {
      if (!floor.contains(place.position().at())) {
        String where = place.name() + " at " + place.xMm() + "," + place.yMm();
        throw new BadInput(
            file + ": " + where + ": expected a place on the floor (floorWidth, floorHeight)");
      }
    }
    return places;
  }

  private static Obstacles walls(Path file) {
    Obstacles walls = WaypointFiles.read(file).obstacles();
    for (Obstacle wall : walls.all()) {
      if (wall.lifetimeMs() != Obstacle.FOREVER) {
        throw new BadInput(
            file
                + (": an obstacle with lifetime " + wall.lifetimeMs())
                + ": expected -1 (for ever), because a goal once proved unreachable must stay so");
      }
    }
    return walls;
  }

  private List<Pose> drawStarts(int robots, Rng rng) {
    List<Pose> starts = new ArrayList<>();
    double roomMm = bodyMm + MazeTask.MARGIN_MM + SPARE_MM;
    double apartMm = bodyMm + roomMm;
    for (int i = 0; i < TRIES && starts.size() < robots; i++) {
      double x = floor.xMinMm() + rng.nextDouble() * (floor.xMaxMm() - floor.xMinMm());
      double y = floor.yMinMm() + rng.nextDouble() * (floor.yMaxMm() - floor.yMinMm());
      Point at = new Point(x, y);
      if (floor.depthMm(at) > roomMm
          && obstacles.distanceMm(at) > roomMm
          && starts.stream().noneMatch(start -> start.distanceMm(at) < apartMm)
          && goals.stream().noneMatch(goal -> at.distanceMm(goal.at()) < apartMm + TOLERANCE_MM)) {
        starts.add(new Pose(x, y, StrictMath.PI * (2 * rng.nextDouble() - 1)));
      }
    }
    if (starts.size() < robots) {
      throw Places.noRoom(robots, starts.size(), 0);
    }
    return starts;
  }

  private Layout layout(List<Pose> starts) {
    List<Layout.Robot> robots = new ArrayList<>();
    for (int i = 0; i < starts.size(); i++) {
      List<Goal> own = new ArrayList<>();
      for (int j = i; j < goals.size(); j += starts.size()) {
        own.add(goals.get(j));
      }
      robots.add(new Layout.Robot(starts.get(i), own));
    }
    return new Layout(floor, obstacles, robots);
  }

  /** Whether every goal that can be reached can be reached past the other robots' places. */
  private boolean isFreeOfBlocking(Layout layout) {
    return IntStream.range(0, layout.robots().size())
        .mapToObj(i -> layout.task(i, bodyMm, CollisionMode.STOP))
        .allMatch(task ->
            task.goals().stream()
                .allMatch(goal ->
                    !task.hasWay(goal, obstacles, List.of(), bodyMm)
                        || task.hasWay(goal, obstacles, task.others(), bodyMm)));
  }
}
