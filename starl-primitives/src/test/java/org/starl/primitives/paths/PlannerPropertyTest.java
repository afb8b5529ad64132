package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.statistics.Statistics;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

/** Random floors, checked by geometry and a search that are independent of the planners. */
class PlannerPropertyTest {

  /** The larger margin due to rounding to whole mm, and to chords at round corners. */
  private static final double WIDER = 1.01;

  private static final double WIDER_MM = 5;

  private final PathPlanner optimal = new OptimalPlanner();

  @Property(tries = 150)
  void everyPathKeepsTheClearance(
      @ForAll long seed, @ForAll @IntRange(min = 0, max = 14) int obstacles) {
    PlanTask task = task(seed, obstacles);
    for (PathPlanner planner : List.of(optimal, rrt(seed))) {
      Plan plan = planner.plan(task);
      Statistics.label(planner.getClass().getSimpleName()).collect(plan.getClass().getSimpleName());
      if (plan instanceof Plan.Found found) {
        assertLeadsThere(found.path(), task);
        for (int i = 0; i < found.path().legs(); i++) {
          Segment leg = found.path().leg(i);
          assertThat(Floors.clearanceMm(leg, task))
              .as("%s, leg %s of %s", planner.getClass().getSimpleName(), i, found.path())
              .isGreaterThanOrEqualTo(task.bodyRadiusMm() + task.clearanceMm());
        }
      }
    }
  }

  @Property(tries = 100)
  void theOptimalPlannerIsNeverWorseThanTheRandomOne(
      @ForAll long seed, @ForAll @IntRange(min = 0, max = 14) int obstacles) {
    PlanTask task = task(seed, obstacles);
    Plan random = rrt(seed).plan(task);
    Plan best = optimal.plan(task);
    if (random instanceof Plan.Found found) {
      assertThat(best).isInstanceOf(Plan.Found.class);
      assertThat(lengthMm(best)).isLessThanOrEqualTo(found.path().lengthMm() + 1e-6);
    } else if (random instanceof Plan.Blocked) {
      assertThat(best).isEqualTo(random);
    }
  }

  @Property(tries = 60)
  void theOptimalPlannerIsNeverWorseThanAGridSearch(
      @ForAll long seed, @ForAll @IntRange(min = 3, max = 14) int obstacles) {
    PlanTask task = task(seed, obstacles);
    double marginMm = (task.bodyRadiusMm() + task.clearanceMm()) * WIDER + WIDER_MM;
    double oracleMm = new GridOracle(task, marginMm).lengthMm();
    Plan best = optimal.plan(task);
    Statistics.collect(oracleMm < Double.POSITIVE_INFINITY, best.getClass().getSimpleName());
    if (oracleMm < Double.POSITIVE_INFINITY) {
      assertThat(best).isInstanceOf(Plan.Found.class);
      assertThat(lengthMm(best)).isLessThanOrEqualTo(oracleMm + 2);
    }
  }

  @Property(tries = 30)
  void equalTasksGiveEqualPlans(@ForAll long seed) {
    assertThat(optimal.plan(task(seed, 8))).isEqualTo(optimal.plan(task(seed, 8)));
    assertThat(rrt(seed).plan(task(seed, 8))).isEqualTo(rrt(seed).plan(task(seed, 8)));
  }

  private static PlanTask task(long seed, int obstacles) {
    return Floors.random(new Rng(seed), obstacles, 100, 20);
  }

  private static PathPlanner rrt(long seed) {
    return new RrtPlanner(new RrtSettings(2_000, 300, 0.1, 100), seed);
  }

  private static double lengthMm(Plan plan) {
    return plan instanceof Plan.Found found ? found.path().lengthMm() : Double.NaN;
  }

  private static void assertLeadsThere(Path path, PlanTask task) {
    assertThat(path.start()).isEqualTo(rounded(task.start()));
    assertThat(path.goal()).isEqualTo(rounded(task.goal()));
  }

  private static Point rounded(Point point) {
    return new Point(StrictMath.round(point.xMm()), StrictMath.round(point.yMm()));
  }
}
