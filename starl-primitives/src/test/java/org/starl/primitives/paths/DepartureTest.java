package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Segment;
import org.starl.random.Rng;

/** Robots close beside each other's tubes, where the planner's larger margin leaves no path. */
class DepartureTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 8000, 8000);
  private static final Point MIDDLE = new Point(4000, 4000);
  private static final int RADIUS_MM = 348;
  private static final double BODY_MM = 165;
  private static final double REACH_MM = 120;

  private final PathPlanner planner = new OptimalPlanner();

  @Test
  void aRobotLeavesBesideAPassingTube() {
    int stuck = 0;
    Tube standing = Tube.disc(MIDDLE, RADIUS_MM);
    for (long seed = 1; seed <= 40; seed++) {
      Rng rng = new Rng(seed);
      Tube passing = passing(standing, rng);
      PlanTask task = task(MIDDLE, goal(rng), passing);
      stuck += isStuck(planner.plan(task)) ? 1 : 0;
      assertLeaves(task, MIDDLE, passing);
    }
    assertThat(stuck).as("tubes so close that the planner alone finds no path").isPositive();
  }

  @Test
  void aRobotThatStoppedBesideAnotherLeaves() {
    int stuck = 0;
    Tube standing = Tube.disc(MIDDLE, RADIUS_MM);
    for (long seed = 1; seed <= 40; seed++) {
      Rng rng = new Rng(seed);
      Tube passing = passing(standing, rng);
      for (int i = 0; i < passing.parts(); i++) {
        Segment leg = passing.part(i).axis();
        Point stop = leg.from().plus(leg.to().minus(leg.from()).times(rng.nextDouble()));
        PlanTask task = task(stop, goal(rng), standing);
        stuck += isStuck(planner.plan(task)) ? 1 : 0;
        assertLeaves(task, stop, standing);
      }
    }
    assertThat(stuck).as("stops so close that the planner alone finds no path").isPositive();
  }

  @Test
  void aFreeStartIsUsedUnchanged() {
    PlanTask task =
        task(MIDDLE, new Point(7000, 1000), Tube.disc(new Point(4000, 4800), RADIUS_MM));
    assertThat(new Departure(MIDDLE, REACH_MM).plan(planner, task)).isEqualTo(planner.plan(task));
  }

  @Test
  void aStartTooFarFromFreePlacesIsBlocked() {
    Point beside = new Point(4000, 4000 + RADIUS_MM - REACH_MM - 5);
    Obstacles wall = Obstacles.of(Obstacle.wall(new Point(0, 4000), new Point(8000, 4000)));
    PlanTask far = task(beside, new Point(4000, 7000), wall, List.of());
    PlanTask near = far.from(new Point(4000, 4000 + RADIUS_MM - REACH_MM / 2));
    assertThat(isStuck(new Departure(far.start(), REACH_MM).plan(planner, far))).isTrue();
    assertThat(isStuck(new Departure(near.start(), REACH_MM).plan(planner, near))).isFalse();
  }

  /** A tube that passes {@code standing}. */
  private Tube passing(Tube standing, Rng rng) {
    Point from = place(rng);
    Point to = MIDDLE.plus(MIDDLE.minus(from)).plus(new Point(0, rng.nextLong(-600, 600)));
    Plan plan = planner.plan(task(from, to, standing));
    assertThat(plan).isInstanceOf(Plan.Found.class);
    Tube tube = Tracking.tube(((Plan.Found) plan).path(), RADIUS_MM, 1_000);
    assertThat(tube).isNotNull();
    return tube;
  }

  private void assertLeaves(PlanTask task, Point here, Tube other) {
    Plan plan = new Departure(here, REACH_MM).plan(planner, task);
    assertThat(plan).as("%s beside %s", here, other).isInstanceOf(Plan.Found.class);
    Path path = ((Plan.Found) plan).path();
    assertThat(path.start().distanceMm(here)).isLessThanOrEqualTo(REACH_MM);
    Tube tube = Tracking.tube(path, RADIUS_MM, 1_000);
    assertThat(tube).isNotNull();
    assertThat(tube.meets(other)).as("%s beside %s", tube, other).isFalse();
    assertThat(tube.part(0).containsDisc(here, BODY_MM)).isTrue();
  }

  private static boolean isStuck(Plan plan) {
    return plan.equals(new Plan.Blocked(Plan.End.START));
  }

  /** A place left or right of the middle. */
  private static Point place(Rng rng) {
    return new Point(rng.nextBoolean(0.5) ? 2500 : 5500, rng.nextLong(2_500, 5_500));
  }

  /** A place above or below all these places. */
  private static Point goal(Rng rng) {
    return new Point(4000, rng.nextBoolean(0.5) ? 800 : 7200);
  }

  private static PlanTask task(Point start, Point goal, Tube other) {
    return task(start, goal, Obstacles.NONE, other.capsules());
  }

  private static PlanTask task(Point start, Point goal, Obstacles walls, List<Capsule> taken) {
    return new PlanTask(start, goal, FLOOR, walls, taken, BODY_MM, RADIUS_MM - BODY_MM);
  }
}
