package org.starl.apps.maze;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.starl.apps.maze.logic.Errand;
import org.starl.apps.maze.logic.Goal;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.input.BadInput;
import org.starl.primitives.paths.Capsule;
import org.starl.primitives.paths.LocalPlanner;
import org.starl.primitives.paths.Plan;
import org.starl.primitives.paths.PlanTask;
import org.starl.random.Rng;
import org.starl.sim.world.Waypoint;
import org.starl.sim.world.WaypointFiles;

/**
 * The original StarL's files: {@code dest.wpt} with the goals, which are dealt to the robots in turn,
 * {@code obstacles.wpt}, and, if it is there, {@code start.wpt} with the robots' poses. Starts are
 * drawn where there is none.
 */
final class FileMaze {

  private static final double TOLERANCE_MM = 20;
  private static final int TRIES = 2_000;
  private static final int ROUNDS = 50;

  /** A planner asks for a little more room than the margin. */
  private static final double SPARE_MM = 10;

  private final Rectangle floor;
  private final double bodyMm;
  private final Rng rng;
  private final Obstacles obstacles;
  private final List<Waypoint> goals;

  private FileMaze(Path folder, Rectangle floor, double bodyMm, Rng rng) {
    this.floor = floor;
    this.bodyMm = bodyMm;
    this.rng = rng;
    Path dest = folder.resolve("dest.wpt");
    goals = WaypointFiles.read(dest).waypoints();
    Path walls = folder.resolve("obstacles.wpt");
    obstacles = WaypointFiles.read(walls).obstacles();
    if (goals.isEmpty()) {
      throw new BadInput(dest + ": no goal: expected a line WAY,x,y,angle,name[,radius]");
    }
    for (Obstacle obstacle : obstacles.all()) {
      if (obstacle.lifetimeMs() != Obstacle.FOREVER) {
        throw new BadInput(
            walls
                + ": an obstacle with lifetime "
                + obstacle.lifetimeMs()
                + ": expected -1: what vanishes cannot be proven to be in the way");
      }
    }
    goals.forEach(goal -> requireOnFloor(dest, goal));
  }

  static Layout read(Path folder, Rectangle floor, int robots, double bodyMm, Rng rng) {
    FileMaze maze = new FileMaze(folder, floor, bodyMm, rng);
    Path starts = folder.resolve("start.wpt");
    if (Files.exists(starts)) {
      return maze.layout(maze.fromFile(starts, robots));
    }
    for (int i = 0; i < ROUNDS; i++) {
      Layout layout = maze.layout(maze.drawn(robots));
      if (maze.nobodyIsInTheWay(layout)) {
        return layout;
      }
    }
    throw new BadInput(
        "robots: " + robots + ": expected fewer: they would stand in each other's only way");
  }

  private void requireOnFloor(Path file, Waypoint place) {
    if (!floor.contains(new Point(place.xMm(), place.yMm()))) {
      throw new BadInput(
          file
              + ": "
              + place.name()
              + " at "
              + place.xMm()
              + ","
              + place.yMm()
              + ": expected on the floor (floorWidth, floorHeight)");
    }
  }

  private List<Pose> fromFile(Path file, int robots) {
    List<Pose> starts = new ArrayList<>();
    for (Waypoint start : WaypointFiles.read(file).waypoints()) {
      requireOnFloor(file, start);
      if (starts.size() < robots) {
        starts.add(start.position().pose());
      }
    }
    if (starts.size() < robots) {
      throw new BadInput(file + ": " + starts.size() + " starts: expected " + robots);
    }
    return starts;
  }

  private List<Pose> drawn(int robots) {
    List<Pose> starts = new ArrayList<>();
    for (int i = 0; i < TRIES && starts.size() < robots; i++) {
      double x = floor.xMinMm() + rng.nextDouble() * (floor.xMaxMm() - floor.xMinMm());
      double y = floor.yMinMm() + rng.nextDouble() * (floor.yMaxMm() - floor.yMinMm());
      Point at = new Point(x, y);
      double roomMm = bodyMm + Errand.MARGIN_MM + SPARE_MM;
      if (floor.depthMm(at) > roomMm
          && obstacles.distanceMm(at) > roomMm
          && isFarFromAll(at, starts, 2 * bodyMm + Errand.MARGIN_MM + SPARE_MM)) {
        starts.add(new Pose(x, y, StrictMath.PI * (2 * rng.nextDouble() - 1)));
      }
    }
    if (starts.size() < robots) {
      throw new BadInput("robots: " + robots + ": no room for more than " + starts.size());
    }
    return starts;
  }

  private boolean isFarFromAll(Point at, List<Pose> starts, double mm) {
    for (Pose start : starts) {
      if (start.distanceMm(at) < mm) {
        return false;
      }
    }
    for (Waypoint goal : goals) {
      if (at.distanceMm(new Point(goal.xMm(), goal.yMm())) < mm + TOLERANCE_MM) {
        return false;
      }
    }
    return true;
  }

  private Layout layout(List<Pose> starts) {
    List<Layout.Robot> robots = new ArrayList<>();
    for (int i = 0; i < starts.size(); i++) {
      List<Goal> mine = new ArrayList<>();
      for (int j = i; j < goals.size(); j += starts.size()) {
        Waypoint goal = goals.get(j);
        double toleranceMm = Math.max(1, goal.radiusMm().orElse(TOLERANCE_MM));
        mine.add(new Goal(goal.name(), new Point(goal.xMm(), goal.yMm()), toleranceMm));
      }
      robots.add(new Layout.Robot(starts.get(i), mine));
    }
    return new Layout(floor, obstacles, robots);
  }

  /** Whether all that can be reached can be reached past the others. */
  private boolean nobodyIsInTheWay(Layout layout) {
    for (int i = 0; layout.robots().size() > 1 && i < layout.robots().size(); i++) {
      Layout.Robot robot = layout.robots().get(i);
      for (Goal goal : robot.goals()) {
        boolean alone = leadsTo(goal, robot.start().at(), List.of());
        if (alone && !leadsTo(goal, robot.start().at(), layout.others(i, bodyMm))) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean leadsTo(Goal goal, Point from, List<Capsule> others) {
    double clearanceMm = Errand.MARGIN_MM;
    Plan plan =
        new LocalPlanner()
            .plan(new PlanTask(from, goal.at(), floor, obstacles, others, bodyMm, clearanceMm));
    return plan instanceof Plan.Found;
  }
}
