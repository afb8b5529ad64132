package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** Removes exactly the corners that the extra clearance allows. */
class FewerCornersTest {

  private static final PlanTask TASK =
      new PlanTask(
          new Point(0, 0),
          new Point(1000, 0),
          new Rectangle(-500, -500, 1500, 500),
          Obstacles.NONE,
          List.of(),
          150,
          50);

  private static Plan plan(Plan wide, Plan narrow) {
    PathPlanner other = task -> task.clearanceMm() == 50 + FewerCorners.SPARE_MM ? wide : narrow;
    return new FewerCorners(other).plan(TASK);
  }

  private static Plan path(Point... points) {
    return new Plan.Found(new Path(List.of(points)));
  }

  @Test
  void onlyPointsNearTheNewLineAreRemoved() {
    Point start = new Point(0, 0);
    Point goal = new Point(1000, 0);
    Point near = new Point(300, 18);
    Point far = new Point(600, 60);
    assertThat(plan(path(start, near, goal), path(start, far, goal))).isEqualTo(path(start, goal));
    assertThat(plan(path(start, far, goal), path(start, goal))).isEqualTo(path(start, far, goal));
  }

  @Test
  void anEndWithoutSpareClearanceGetsTheOtherPlannersPath() {
    Plan narrow = path(new Point(0, 0), new Point(300, 18), new Point(1000, 0));
    assertThat(plan(new Plan.Blocked(Plan.End.START), narrow)).isEqualTo(narrow);
    assertThat(plan(new Plan.NoPath(), narrow)).isEqualTo(new Plan.NoPath());
  }
}
