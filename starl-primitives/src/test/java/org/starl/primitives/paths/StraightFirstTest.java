package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

/** Uses the straight line exactly where it is free. */
class StraightFirstTest {

  private static final Rectangle BOUNDS = new Rectangle(0, 0, 4_000, 4_000);
  private static final double MARGIN_MM = 250;
  private static final Plan OTHER = new Plan.NoPath();

  private static PlanTask task(Point from, Point to, Obstacles obstacles, List<Capsule> taken) {
    return new PlanTask(from, to, BOUNDS, obstacles, taken, 150, MARGIN_MM - 150);
  }

  private static Plan plan(PlanTask task) {
    return new StraightFirst(any -> OTHER).plan(task);
  }

  private static Point drawn(Rng rng) {
    return new Point(rng.nextInt(4_001), rng.nextInt(4_001));
  }

  @Property(tries = 300)
  void aStraightPathKeepsTheMargin(@ForAll long seed) {
    Rng rng = new Rng(seed);
    Obstacles obstacles =
        Obstacles.of(
            Obstacle.wall(drawn(rng), drawn(rng)),
            Obstacle.body(drawn(rng), drawn(rng), drawn(rng)));
    List<Capsule> taken = List.of(new Capsule(new Segment(drawn(rng), drawn(rng)), 250));
    Point from = drawn(rng);
    Point to = drawn(rng);
    double nearestMm = Double.POSITIVE_INFINITY;
    for (int i = 0; i <= 400; i++) {
      Point at = from.plus(to.minus(from).times(i / 400.0));
      nearestMm = Math.min(nearestMm, obstacles.distanceMm(at));
      nearestMm = Math.min(nearestMm, taken.get(0).axis().distanceMm(at) - 250);
      nearestMm = Math.min(nearestMm, BOUNDS.depthMm(at));
    }
    Plan plan = plan(task(from, to, obstacles, taken));
    if (nearestMm < MARGIN_MM) {
      assertThat(plan).as("seed %d", seed).isEqualTo(OTHER);
    } else if (nearestMm > MARGIN_MM + 20) {
      assertThat(plan).as("seed %d", seed).isEqualTo(new Plan.Found(new Path(List.of(from, to))));
    }
  }

  @Test
  void theEndsAreInWholeMillimetres() {
    Plan plan = plan(task(new Point(500.4, 600), new Point(900.6, 700), Obstacles.NONE, List.of()));
    assertThat(plan)
        .isEqualTo(new Plan.Found(new Path(List.of(new Point(500, 600), new Point(901, 700)))));
  }

  @Test
  void theOtherPlannerPlansIfStartAndGoalAreEqual() {
    Point here = new Point(500, 600);
    assertThat(plan(task(here, here, Obstacles.NONE, List.of()))).isEqualTo(OTHER);
  }
}
