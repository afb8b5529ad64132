package org.starl.primitives.paths;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;

/**
 * As {@link OptimalPlanner}, but looks no farther than it must: first at the floor around both ends,
 * then at more and more of it. For large floors. The path that it finds is the shortest one of the
 * part that it looked at, not always of the whole floor; {@code NoPath} is proven for the whole floor:
 * either by looking at all of it, or because one end lies in a room that is closed all round within
 * the part. A part is drawn on whole millimetres of its own: where less than 3 mm decide whether a
 * body fits, one of the two planners may find a way, and the other none.
 */
public final class LocalPlanner implements PathPlanner {

  private static final double FIRST_REACH_MM = 2_500;
  private static final double GROWTH = 3;

  private final double firstReachMm;

  public LocalPlanner() {
    this(FIRST_REACH_MM);
  }

  /**
   * @param firstReachMm the first part reaches so far beyond the ends, and twice the margin
   */
  public LocalPlanner(double firstReachMm) {
    this.firstReachMm = firstReachMm;
  }

  @Override
  public Plan plan(PlanTask task) {
    return planFromNear(task, 0);
  }

  /**
   * For a body that is a little nearer to something than it should be: the way begins at the nearest
   * free place, if there is one within {@code slackMm} of the start, as its first point says. The body
   * has to get there, by the straight line, at its own risk.
   */
  public Plan planFromNear(PlanTask task, int slackMm) {
    double reachMm = firstReachMm + 2 * task.marginMm();
    while (true) {
      Rectangle window = window(task, reachMm);
      Plan plan = within(window, task, slackMm);
      if (plan != null) {
        return plan;
      }
      reachMm *= GROWTH;
    }
  }

  /** The answer, if this part of the floor has it. */
  private static @Nullable Plan within(Rectangle window, PlanTask task, int slackMm) {
    boolean isWhole = window.equals(task.bounds());
    FreeSpace space = FloorPlan.of(isWhole ? task : part(window, task));
    Ends ends = Ends.of(task).free(space, slackMm);
    Plan.Blocked blocked = ends.blockedIn(space);
    if (blocked != null) {
      return blocked;
    }
    if (isWhole) {
      return OptimalPlanner.search(space, ends);
    }
    int startRoom = space.room(ends.startX(), ends.startY());
    int goalRoom = space.room(ends.goalX(), ends.goalY());
    if (startRoom != goalRoom) {
      boolean isProven =
          isClosed(space, startRoom, window, task) || isClosed(space, goalRoom, window, task);
      return isProven ? new Plan.NoPath() : null;
    }
    return OptimalPlanner.search(space, ends) instanceof Plan.Found found ? found : null;
  }

  /** Whether a room ends before all sides of the part behind which there is more floor. */
  private static boolean isClosed(FreeSpace space, int room, Rectangle part, PlanTask task) {
    Rectangle all = task.bounds();
    return !space.reachesSide(
        room,
        part.xMinMm() > all.xMinMm(),
        part.yMinMm() > all.yMinMm(),
        part.xMaxMm() < all.xMaxMm(),
        part.yMaxMm() < all.yMaxMm());
  }

  /** Around both ends, on the floor; an end that is off it is Blocked anyway. */
  private static Rectangle window(PlanTask task, double reachMm) {
    Rectangle all = task.bounds();
    Point a = task.start();
    Point b = task.goal();
    double xMin = Math.max(all.xMinMm(), Math.min(a.xMm(), b.xMm()) - reachMm);
    double yMin = Math.max(all.yMinMm(), Math.min(a.yMm(), b.yMm()) - reachMm);
    double xMax = Math.min(all.xMaxMm(), Math.max(a.xMm(), b.xMm()) + reachMm);
    double yMax = Math.min(all.yMaxMm(), Math.max(a.yMm(), b.yMm()) + reachMm);
    return xMin < xMax && yMin < yMax ? new Rectangle(xMin, yMin, xMax, yMax) : all;
  }

  /** With all that is in the way in the part, and as little else as can be told at a glance. */
  private static PlanTask part(Rectangle window, PlanTask task) {
    double marginMm = 2 * task.marginMm();
    List<Obstacle> obstacles = new ArrayList<>();
    for (Obstacle obstacle : task.obstacles().all()) {
      if (isNear(window, obstacle.points(), marginMm)) {
        obstacles.add(obstacle);
      }
    }
    List<Capsule> taken = new ArrayList<>();
    for (Capsule capsule : task.taken()) {
      List<Point> ends = List.of(capsule.axis().from(), capsule.axis().to());
      if (isNear(window, ends, marginMm + capsule.radiusMm())) {
        taken.add(capsule);
      }
    }
    List<Polygon> keepOut = new ArrayList<>();
    for (Polygon place : task.keepOut()) {
      if (isNear(window, place.vertices(), marginMm)) {
        keepOut.add(place);
      }
    }
    return new PlanTask(
        task.start(),
        task.goal(),
        window,
        new Obstacles(obstacles),
        taken,
        keepOut,
        task.bodyRadiusMm(),
        task.clearanceMm());
  }

  /** Whether the box around the points comes so near. */
  private static boolean isNear(Rectangle window, List<Point> points, double rangeMm) {
    boolean left = true;
    boolean right = true;
    boolean below = true;
    boolean above = true;
    for (Point point : points) {
      left &= point.xMm() < window.xMinMm() - rangeMm;
      right &= point.xMm() > window.xMaxMm() + rangeMm;
      below &= point.yMm() < window.yMinMm() - rangeMm;
      above &= point.yMm() > window.yMaxMm() + rangeMm;
    }
    return !(left || right || below || above);
  }
}
