package org.starl.primitives.paths;

import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/**
 * Like {@link OptimalPlanner}, but for large floors: it searches a window around start and goal
 * first, and then larger windows. The path is the shortest in its window, not always on the whole
 * floor. {@code NoPath} is proven for the whole floor: the window is the whole floor, or one end is
 * in a room that is closed within the window. Each window is rounded to whole mm separately: where
 * less than 3 mm decide whether a body fits, only one of the two planners may find a path.
 */
public final class LocalPlanner implements PathPlanner {

  private static final double FIRST_REACH_MM = 2_500;
  private static final double GROWTH = 3;

  private final double firstReachMm;

  public LocalPlanner() {
    this(FIRST_REACH_MM);
  }

  /**
   * @param firstReachMm the first window extends this far beyond the ends, plus twice the margin
   */
  public LocalPlanner(double firstReachMm) {
    this.firstReachMm = firstReachMm;
  }

  @Override
  public Plan plan(PlanTask task) {
    return planFromNear(task, 0);
  }

  /**
   * Plans for a body that is slightly too close to an obstacle: the path begins at the nearest free
   * place within {@code slackMm} of the start, if there is one. The straight line from the start to
   * the path's first point is not checked.
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

  /** The answer, or null if it needs a larger window. */
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

  /** Whether a room does not reach the sides of the window that are inside the floor. */
  private static boolean isClosed(FreeSpace space, int room, Rectangle part, PlanTask task) {
    Rectangle all = task.bounds();
    return !space.reachesSide(
        room,
        part.xMinMm() > all.xMinMm(),
        part.yMinMm() > all.yMinMm(),
        part.xMaxMm() < all.xMaxMm(),
        part.yMaxMm() < all.yMaxMm());
  }

  /** The window around both ends, within the floor; an end outside the floor is Blocked anyway. */
  private static Rectangle window(PlanTask task, double reachMm) {
    Rectangle all = task.bounds();
    Rectangle near = Rectangle.around(List.of(task.start(), task.goal())).widened(reachMm);
    double xMin = Math.max(all.xMinMm(), near.xMinMm());
    double yMin = Math.max(all.yMinMm(), near.yMinMm());
    double xMax = Math.min(all.xMaxMm(), near.xMaxMm());
    double yMax = Math.min(all.yMaxMm(), near.yMaxMm());
    return xMin < xMax && yMin < yMax ? new Rectangle(xMin, yMin, xMax, yMax) : all;
  }

  /** The task in the window, without obstacles whose bounding boxes are far from it. */
  private static PlanTask part(Rectangle window, PlanTask task) {
    double marginMm = 2 * task.marginMm();
    return new PlanTask(
        task.start(),
        task.goal(),
        window,
        new Obstacles(
            task.obstacles().all().stream()
                .filter(obstacle -> isNear(window, obstacle.points(), marginMm))
                .collect(Collectors.toList())),
        task.taken().stream()
            .filter(capsule ->
                isNear(
                    window,
                    List.of(capsule.axis().from(), capsule.axis().to()),
                    marginMm + capsule.radiusMm()))
            .collect(Collectors.toList()),
        task.keepOut().stream()
            .filter(place -> isNear(window, place.vertices(), marginMm))
            .collect(Collectors.toList()),
        task.bodyRadiusMm(),
        task.clearanceMm());
  }

  /** Whether the bounding box of the points is within {@code rangeMm} of the window. */
  private static boolean isNear(Rectangle window, List<Point> points, double rangeMm) {
    Rectangle near = window.widened(rangeMm);
    Rectangle box = Rectangle.around(points);
    return box.xMaxMm() >= near.xMinMm()
        && box.xMinMm() <= near.xMaxMm()
        && box.yMaxMm() >= near.yMinMm()
        && box.yMinMm() <= near.yMaxMm();
  }
}
