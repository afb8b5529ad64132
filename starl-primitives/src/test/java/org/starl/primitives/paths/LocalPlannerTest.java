package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.Statistics;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

/** Compares the planner for parts of the floor with the one for the whole floor. */
class LocalPlannerTest {

  private final PathPlanner optimal = new OptimalPlanner();
  private final PathPlanner local = new LocalPlanner(50);

  /** Rounding makes obstacles wider or narrower by up to this length. */
  private static final double ROUNDING_MM = 3;

  @Property(tries = 300)
  void aPathIsFoundWhereTheOptimalPlannerFindsOne(
      @ForAll long seed, @ForAll @IntRange(min = 0, max = 16) int obstacles) {
    PlanTask task = Floors.random(new Rng(seed), obstacles, 100, 20);
    Plan part = local.plan(task);
    Plan wider = optimal.plan(withClearance(task, 20 + ROUNDING_MM));
    Plan narrower = optimal.plan(withClearance(task, 20 - ROUNDING_MM));
    // The two planners may differ only where rounding decides.
    boolean isClear = wider.getClass() == narrower.getClass();
    Statistics.collect(isClear ? wider.getClass().getSimpleName() : "rounding decides");
    if (isClear) {
      assertThat(part.getClass()).isEqualTo(wider.getClass());
    }
    if (part instanceof Plan.Found found) {
      Path path = found.path();
      assertThat(path.start()).isEqualTo(whole(task.start()));
      assertThat(path.goal()).isEqualTo(whole(task.goal()));
      for (int i = 0; i < path.legs(); i++) {
        assertThat(Floors.clearanceMm(path.leg(i), task)).isGreaterThanOrEqualTo(120);
      }
    }
  }

  @Example
  void aClosedRoomIsFoundWithoutTheWholeFloor() {
    List<Obstacle> all = new ArrayList<>();
    all.add(box(0, 0, 2_000, 2_000));
    for (int i = 0; i < 40; i++) {
      all.add(box(5_000 + 1_000 * i, 50_000, 500, 500));
    }
    Rectangle floor = new Rectangle(-50_000, -50_000, 50_000, 60_000);
    Point inside = new Point(1_000, 1_000);
    Point outside = new Point(4_000, 1_000);
    Obstacles walls = new Obstacles(all);
    for (boolean out : new boolean[] {true, false}) {
      PlanTask task =
          new PlanTask(
              out ? inside : outside, out ? outside : inside, floor, walls, List.of(), 165, 75);
      assertThat(local.plan(task)).isEqualTo(new Plan.NoPath());
    }
  }

  @Example
  void theCentreAvoidsKeepOutAreas() {
    Polygon bar =
        Polygon.of(
            new Point(1_900, 200),
            new Point(2_100, 200),
            new Point(2_100, 2_500),
            new Point(1_900, 2_500));
    Plan plan = local.plan(around(bar));
    assertThat(plan).isInstanceOf(Plan.Found.class);
    Path path = ((Plan.Found) plan).path();
    for (int i = 0; i < path.legs(); i++) {
      Segment leg = path.leg(i);
      for (int j = 0; j <= 100; j++) {
        Point at = leg.from().plus(leg.to().minus(leg.from()).times(j / 100.0));
        assertThat(bar.depthMm(at)).as("%s", at).isLessThan(1);
      }
    }
    // The area is not widened: the path leads along its border.
    assertThat(path.points()).contains(new Point(1_900, 200));
  }

  @Example
  void aKeepOutAreaAcrossTheFloorLeavesNoPath() {
    Polygon bar =
        Polygon.of(
            new Point(1_900, 0),
            new Point(2_100, 0),
            new Point(2_100, 3_000),
            new Point(1_900, 3_000));
    assertThat(local.plan(around(bar))).isEqualTo(new Plan.NoPath());
    assertThat(optimal.plan(around(bar))).isEqualTo(new Plan.NoPath());
  }

  private static PlanTask around(Polygon place) {
    return new PlanTask(
        new Point(500, 500),
        new Point(3_500, 500),
        Floors.BOUNDS,
        Obstacles.NONE,
        List.of(),
        List.of(place),
        100,
        0);
  }

  private static Obstacle box(double x, double y, double width, double height) {
    Point a = new Point(x, y);
    Point b = new Point(x + width, y);
    Point c = new Point(x + width, y + height);
    Point d = new Point(x, y + height);
    return Obstacle.wall(a, b, c, d, a);
  }

  private static PlanTask withClearance(PlanTask task, double clearanceMm) {
    return task.withClearanceMm(clearanceMm);
  }

  private static Point whole(Point point) {
    return new Point(FreeSpace.whole(point.xMm()), FreeSpace.whole(point.yMm()));
  }
}
