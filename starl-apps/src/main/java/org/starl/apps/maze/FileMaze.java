package org.starl.apps.maze;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.starl.apps.maze.logic.CollisionMode;
import org.starl.apps.maze.logic.Errand;
import org.starl.apps.maze.logic.Goal;
import org.starl.apps.maze.spec.MazeTruth;
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
 * The original StarL's files: {@code dest.wpt} with the goals, which are dealt to the robots in turn,
 * {@code obstacles.wpt}, and optionally {@code start.wpt} with the robots' poses. Without it starts are
 * drawn so that every goal that can be reached can be reached past the other robots.
 */
final class FileMaze {

  private static final double TOLERANCE_MM = 20;
  private static final int TRIES = 2_000;
  private static final int ROUNDS = 50;

  // A planner needs a little more room than the margin.
  private static final double SPARE_MM = 10;

  private final Rectangle floor;
  private final double bodyMm;
  private final Rng rng;
  private final Obstacles obstacles;
  private final List<Goal> goals = new ArrayList<>();

  private FileMaze(Path folder, Rectangle floor, double bodyMm, Rng rng) {
    this.floor = floor;
    this.bodyMm = bodyMm;
    this.rng = rng;
    Path dest = folder.resolve("dest.wpt");
    for (Waypoint goal : places(dest)) {
      double toleranceMm = Math.max(1, goal.radiusMm().orElse(TOLERANCE_MM));
      goals.add(new Goal(goal.name(), goal.position().at(), toleranceMm));
    }
    if (goals.isEmpty()) {
      throw new BadInput(dest + ": no goal: expected a line WAY,x,y,angle,name[,radius]");
    }
    Path walls = folder.resolve("obstacles.wpt");
    obstacles = WaypointFiles.read(walls).obstacles();
    for (Obstacle obstacle : obstacles.all()) {
      if (obstacle.lifetimeMs() != Obstacle.FOREVER) {
        throw new BadInput(
            walls
                + (": an obstacle with lifetime " + obstacle.lifetimeMs())
                + ": expected -1: a proof that there is no way must stay true");
      }
    }
  }

  static Layout read(Path folder, Rectangle floor, int robots, double bodyMm, Rng rng) {
    FileMaze maze = new FileMaze(folder, floor, bodyMm, rng);
    Path starts = folder.resolve("start.wpt");
    if (Files.exists(starts)) {
      return maze.layout(maze.fromFile(starts, robots));
    }
    for (int i = 0; i < ROUNDS; i++) {
      Layout layout = maze.layout(maze.drawn(robots));
      if (robots == 1 || maze.isFreeOfBlocking(layout)) {
        return layout;
      }
    }
    throw new BadInput(
        "robots: " + robots + ": expected fewer: they would stand in each other's only way");
  }

  /** The places in a file, all of which must be on the floor. */
  private List<Waypoint> places(Path file) {
    List<Waypoint> places = WaypointFiles.read(file).waypoints();
    for (Waypoint place : places) {
      if (!floor.contains(place.position().at())) {
        String where = place.name() + " at " + place.xMm() + "," + place.yMm();
        throw new BadInput(
            file + ": " + where + ": expected on the floor (floorWidth, floorHeight)");
      }
    }
    return places;
  }

  private List<Pose> fromFile(Path file, int robots) {
    List<Waypoint> starts = places(file);
    if (starts.size() < robots) {
      throw new BadInput(file + ": " + starts.size() + " starts: expected " + robots);
    }
    return starts.stream().limit(robots).map(start -> start.position().pose()).toList();
  }

  private List<Pose> drawn(int robots) {
    List<Pose> starts = new ArrayList<>();
    double roomMm = bodyMm + Errand.MARGIN_MM + SPARE_MM;
    for (int i = 0; i < TRIES && starts.size() < robots; i++) {
      double x = floor.xMinMm() + rng.nextDouble() * (floor.xMaxMm() - floor.xMinMm());
      double y = floor.yMinMm() + rng.nextDouble() * (floor.yMaxMm() - floor.yMinMm());
      Point at = new Point(x, y);
      double apartMm = bodyMm + roomMm;
      if (floor.depthMm(at) > roomMm
          && obstacles.distanceMm(at) > roomMm
          && starts.stream().noneMatch(start -> start.distanceMm(at) < apartMm)
          && goals.stream().noneMatch(goal -> at.distanceMm(goal.at()) < apartMm + TOLERANCE_MM)) {
        starts.add(new Pose(x, y, StrictMath.PI * (2 * rng.nextDouble() - 1)));
      }
    }
    if (starts.size() < robots) {
      throw new BadInput("robots: " + robots + ": no room for more than " + starts.size());
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
    for (int i = 0; i < layout.robots().size(); i++) {
      Errand errand = layout.errand(i, bodyMm, CollisionMode.STOP);
      for (Goal goal : errand.goals()) {
        if (MazeTruth.leadsTo(errand, goal, obstacles, List.of(), bodyMm)
            && !MazeTruth.leadsTo(errand, goal, obstacles, errand.others(), bodyMm)) {
          return false;
        }
      }
    }
    return true;
  }
}
