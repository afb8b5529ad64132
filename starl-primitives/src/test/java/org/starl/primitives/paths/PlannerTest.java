package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Segment;

/** Floors with known answers. */
class PlannerTest {

  private static final Point WEST = new Point(500, 1500);
  private static final Point EAST = new Point(3500, 1500);

  static List<PathPlanner> planners() {
    return List.of(new OptimalPlanner(), new RrtPlanner(RrtSettings.DEFAULT, 1));
  }

  @ParameterizedTest
  @MethodSource("planners")
  void anEmptyFloorGivesAStraightPath(PathPlanner planner) {
    assertThat(planner.plan(Floors.task(WEST, EAST, 200)))
        .isEqualTo(new Plan.Found(new Path(List.of(WEST, EAST))));
  }

  @ParameterizedTest
  @MethodSource("planners")
  void anEndInOrCloseToAnObstacleIsBlocked(PathPlanner planner) {
    Obstacle block = block(400, 1400, 600, 1600);
    assertThat(planner.plan(Floors.task(WEST, EAST, 200, block)))
        .isEqualTo(blocked(Plan.End.START));
    assertThat(planner.plan(Floors.task(EAST, WEST, 200, block))).isEqualTo(blocked(Plan.End.GOAL));
    Point near = new Point(790, 1500);
    assertThat(planner.plan(Floors.task(near, EAST, 200, block)))
        .isEqualTo(blocked(Plan.End.START));
    Point apart = new Point(810, 1500);
    assertThat(planner.plan(Floors.task(apart, EAST, 200, block))).isInstanceOf(Plan.Found.class);
  }

  @ParameterizedTest
  @MethodSource("planners")
  void anEndOutsideTheFloorIsBlocked(PathPlanner planner) {
    assertThat(planner.plan(Floors.task(new Point(100, 1500), EAST, 200)))
        .isEqualTo(blocked(Plan.End.START));
    assertThat(planner.plan(Floors.task(WEST, new Point(3500, 3500), 200)))
        .isEqualTo(blocked(Plan.End.GOAL));
  }

  @Test
  void anOptimalPathRoundAWallHasTangentsAndAnArc() {
    double marginMm = 200;
    Obstacle wall = Obstacle.wall(new Point(2000, -100), new Point(2000, 1800));
    double directMm = new Point(2000, 1800).distanceMm(WEST);
    double tangentMm = StrictMath.sqrt(directMm * directMm - marginMm * marginMm);
    double turnRad = 2 * (StrictMath.asin(300 / directMm) + StrictMath.asin(marginMm / directMm));
    double exactMm = 2 * tangentMm + marginMm * turnRad;
    Path path = found(new OptimalPlanner().plan(Floors.task(WEST, EAST, marginMm, wall)));
    assertThat(path.lengthMm()).isBetween(exactMm, exactMm + 5);
  }

  @Test
  void aWideMarginIsKeptRoundACornerOfChords() {
    Obstacle wall = Obstacle.wall(new Point(2000, -100), new Point(2000, 500));
    PlanTask task = Floors.task(new Point(950, 950), new Point(3050, 950), 900, wall);
    Path path = found(new OptimalPlanner().plan(task));
    for (int i = 0; i < path.legs(); i++) {
      assertThat(Floors.clearanceMm(path.leg(i), task)).isGreaterThanOrEqualTo(900);
    }
  }

  @Test
  void aGapIsUsedIfItIsWideEnoughForTheMargin() {
    assertThat(throughGap(395)).isInstanceOf(Plan.NoPath.class);
    assertThat(found(throughGap(415)).lengthMm()).isCloseTo(3000, within(5.0));
  }

  @Test
  void aClosedRoomHasNoPathAndTheRandomPlannerGivesUp() {
    Obstacle room =
        Obstacle.wall(
            new Point(100, 1000),
            new Point(1100, 1000),
            new Point(1100, 2100),
            new Point(100, 2100),
            new Point(100, 1000));
    PlanTask task = Floors.task(WEST, EAST, 200, room);
    assertThat(new OptimalPlanner().plan(task)).isEqualTo(new Plan.NoPath());
    PathPlanner random = new RrtPlanner(new RrtSettings(500, 300, 0.1, 100), 1);
    assertThat(random.plan(task)).isEqualTo(new Plan.GaveUp());
  }

  @ParameterizedTest
  @MethodSource("planners")
  void pathsAvoidTakenCapsules(PathPlanner planner) {
    Capsule taken = new Capsule(new Segment(new Point(2000, 0), new Point(2000, 2000)), 250);
    PlanTask task =
        new PlanTask(WEST, EAST, Floors.BOUNDS, Obstacles.NONE, List.of(taken), 165, 35);
    Path path = found(planner.plan(task));
    for (int i = 0; i < path.legs(); i++) {
      assertThat(taken.axis().distanceMm(path.leg(i))).isGreaterThanOrEqualTo(450);
    }
  }

  @ParameterizedTest
  @MethodSource("planners")
  void twoBodiesThatTouchAtACornerLeaveNoGap(PathPlanner planner) {
    Obstacle low = block(1500, -100, 2000, 1500);
    Obstacle high = block(2000, 1500, 2500, 3100);
    Plan plan = planner.plan(Floors.task(WEST, EAST, 200, low, high));
    assertThat(plan).isInstanceOfAny(Plan.NoPath.class, Plan.GaveUp.class);
  }

  @Test
  void aKnownFloorGivesTheSamePointsOnEveryJvm() {
    Obstacle block = block(1500, 1000, 2200, 1900);
    Obstacle wall = Obstacle.wall(new Point(2700, 400), new Point(3000, 2000));
    Path path = found(new OptimalPlanner().plan(Floors.task(WEST, EAST, 200, block, wall)));
    assertThat(text(path))
        .isEqualTo(
            "500,1500 1387,2069 1422,2088 1460,2100 1500,2103 2998,2203 3037,2200 3076,2189 3111,2170"
                + " 3142,2145 3168,2115 3187,2080 3500,1500");
  }

  private static String text(Path path) {
    StringBuilder text = new StringBuilder();
    for (Point point : path.points()) {
      text.append((int) point.xMm()).append(',').append((int) point.yMm()).append(' ');
    }
    return text.toString().strip();
  }

  private static Plan throughGap(double gapMm) {
    Obstacle low = block(1900, -100, 2100, 1500 - gapMm / 2);
    Obstacle high = block(1900, 1500 + gapMm / 2, 2100, 3100);
    return new OptimalPlanner().plan(Floors.task(WEST, EAST, 200, low, high));
  }

  private static Plan blocked(Plan.End end) {
    return new Plan.Blocked(end);
  }

  private static Path found(Plan plan) {
    assertThat(plan).isInstanceOf(Plan.Found.class);
    return ((Plan.Found) plan).path();
  }

  private static Obstacle block(double xMin, double yMin, double xMax, double yMax) {
    return Obstacle.body(
        new Point(xMin, yMin), new Point(xMax, yMin), new Point(xMax, yMax), new Point(xMin, yMax));
  }
}
