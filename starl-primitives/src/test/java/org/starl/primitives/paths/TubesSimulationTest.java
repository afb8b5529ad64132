package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.world.Unsynced;
import org.starl.trace.Instance;

/** Simulated robots whose paths cross, checked by the specification. */
class TubesSimulationTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 8000, 8000);
  private static final TubeSettings PATIENT =
      new TubeSettings(60, 1_000, 120_000, 200, 2_000, 200, 2_000);
  private static final long S = 1_000_000_000;
  private static final long BOUND_NS = 600_000_000_000L;

  private static DistributedPathPlanning planning(GlobalVarHolder gvh, TubeSettings settings) {
    return new DistributedPathPlanning(
        gvh, "floor", gvh.id.participants(), new OptimalPlanner(), FLOOR, settings);
  }

  /** Goes to several places in order; returns the result of each drive. */
  private static final class Traveller extends LogicThread {
    private final TubeSettings settings;
    private final int trips;

    Traveller(GlobalVarHolder gvh, TubeSettings settings, int trips) {
      super(gvh);
      this.settings = settings;
      this.trips = trips;
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths = planning(gvh, settings);
      List<Object> ends = new ArrayList<>();
      await(gvh.gps::hasFix);
      Rng rng = gvh.plat.entropy.fork("trips");
      for (int i = 0; i < trips; i++) {
        paths.goTo(new ItemPosition("goal", rng.nextLong(500, 7_500), rng.nextLong(500, 7_500)));
        await(() -> !paths.isUnderWay());
        ends.add(paths.tubeflag().get() + " " + paths.failure().get());
        sleep(200);
      }
      return ends;
    }
  }

  /** Drives a metre, and tries again. */
  private static final class Driver extends LogicThread {
    private final TubeSettings settings;
    private final long timeoutMs;

    Driver(GlobalVarHolder gvh, TubeSettings settings, long timeoutMs) {
      super(gvh);
      this.settings = settings;
      this.timeoutMs = timeoutMs;
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths = planning(gvh, settings);
      await(gvh.gps::hasFix);
      Point here = gvh.gps.pose().at();
      ItemPosition goal = new ItemPosition("goal", (here.xMm() + 4_000) / 2, here.yMm());
      return List.of(paths.drive(goal, timeoutMs));
    }
  }

  /** Goes to the opposite place. */
  private static final class Crosser extends LogicThread {
    private final TubeSettings settings;

    Crosser(GlobalVarHolder gvh, TubeSettings settings) {
      super(gvh);
      this.settings = settings;
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths =
          new DistributedPathPlanning(
              gvh,
              "floor",
              gvh.id.participants(),
              new RrtPlanner(
                  new RrtSettings(1_000, 500, 0.1, 50), gvh.plat.entropy.fork("rrt").nextLong()),
              FLOOR,
              settings);
      await(gvh.gps::hasFix);
      Point here = gvh.gps.pose().at();
      paths.goTo(new ItemPosition("opposite", 8_000 - here.xMm(), 8_000 - here.yMm()));
      await(() -> !paths.isUnderWay());
      return List.of(paths.tubeflag().get() + " " + paths.failure().get());
    }
  }

  private static Simulation.Builder ring(long seed, SimSettings settings) {
    Simulation.Builder builder =
        Simulation.builder().seed(seed).settings(settings).monitor(() -> new TubesSpec(BOUND_NS));
    builder.obstacles(Obstacles.of(Obstacle.wall(new Point(3500, 4000), new Point(4500, 4000))));
    return builder;
  }

  private static Pose onRing(int i, int robots) {
    double angle = 2 * StrictMath.PI * i / robots;
    return new Pose(
        4000 + 3000 * StrictMath.cos(angle), 4000 + 3000 * StrictMath.sin(angle), angle);
  }

  private static SimSettings weather(String loss, String noise) {
    return SimSettings.builder()
        .set("messageLoss", loss)
        .set("messageDelay", "uniform(10ms,100ms)")
        .set("positionNoise", noise)
        .set("headingNoise", "1deg")
        .set("duration", "900s")
        .build();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void crossingRobotsArriveInSeparateTubes(long seed) {
    int robots = 5;
    Simulation.Builder builder = ring(seed, weather("0.2", "10mm"));
    for (int i = 0; i < robots; i++) {
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i), onRing(i, robots), true, gvh -> new Crosser(gvh, PATIENT)));
    }
    SimResult result = builder.build().run();
    assertHolds(result);
    assertThat(result.results().values())
        .as(String.valueOf(result.results()))
        .allMatch(ends -> ends.equals(List.of("DONE NONE")));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void robotsReachManyGoalsDespiteMessageLoss(long seed) {
    int robots = 5;
    Simulation.Builder builder = ring(seed, weather("0.3", "20mm"));
    TubeSettings hasty = new TubeSettings(60, 1_000, 20_000, 200, 2_000, 200, 2_000);
    for (int i = 0; i < robots; i++) {
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              onRing(i, robots),
              true,
              gvh -> new Traveller(gvh, hasty, 4)));
    }
    SimResult result = builder.build().run();
    assertHolds(result);
    assertThat(result.results()).hasSize(robots);
    assertThat(countOf(result, "DONE NONE")).isGreaterThanOrEqualTo(8);
  }

  /** Robots crash while driving, some for ever; some restart, with or without their last writes. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void aCrashedRobotKeepsItsTubeAndOthersAvoidItOrFail(long seed) {
    int robots = 5;
    SimSettings slowDisk =
        weather("0.1", "10mm").toBuilder()
            .set("stableDelay", "80ms")
            .set("computeTime", "300ms")
            .build();
    TubeSettings hasty = new TubeSettings(60, 1_000, 30_000, 200, 2_000, 200, 2_000);
    Simulation.Builder builder = ring(seed, slowDisk);
    for (int i = 0; i < robots; i++) {
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              onRing(i, robots),
              true,
              gvh -> new Traveller(gvh, hasty, 3)));
    }
    builder.director(control -> {
      Rng rng = control.scenarioRng("crashes");
      control.at(rng.nextLong(2, 12) * S, () -> control.crash(new RobotId("bot4")));
      for (int i = 0; i < 3; i++) {
        RobotId victim = new RobotId("bot" + i);
        control.at(
            rng.nextLong(1_000, 20_000) * S / 1_000,
            () -> crashOnce(control, victim, rng.nextLong(1, 4) * S, rng.nextInt(3)));
      }
    });
    SimResult result = builder.build().run();
    assertHolds(result);
    assertThat(result.results()).hasSize(robots - 1);
    assertThat(countOf(result, "DONE NONE")).isPositive();
  }

  private static void crashOnce(SimControl control, RobotId victim, long downNs, int what) {
    if (control.isUp(victim) && !control.isFinished(victim)) {
      control.crash(victim, downNs, Unsynced.values()[what]);
    }
  }

  @Test
  void aDriveFailsDuringTotalLossAndSucceedsAfterIt() {
    int robots = 3;
    TubeSettings hasty = new TubeSettings(60, 1_000, 10_000, 200, 2_000, 200, 2_000);
    SimSettings deaf = weather("0", "0mm").toBuilder().set("faults", "loss(1,until=25s)").build();
    Simulation.Builder builder = ring(7, deaf);
    for (int i = 0; i < robots; i++) {
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              onRing(i, robots),
              true,
              gvh -> new Traveller(gvh, hasty, 5)));
    }
    SimResult result = builder.build().run();
    assertHolds(result);
    assertThat(result.results().values())
        .allSatisfy(ends -> assertThat(ends).startsWith("FAIL DEADLINE").contains("DONE NONE"));
  }

  @Test
  void aDriveIsTriedAgainUntilItsTimeIsOver() {
    TubeSettings hasty = new TubeSettings(60, 1_000, 10_000, 200, 2_000, 200, 2_000);
    SimSettings deaf = weather("0", "0mm").toBuilder().set("faults", "loss(1,until=25s)").build();
    Simulation.Builder builder = ring(7, deaf);
    for (int i = 0; i < 3; i++) {
      long timeoutMs = i == 0 ? 5_000 : 60_000;
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              onRing(i, 3),
              true,
              gvh -> new Driver(gvh, hasty, timeoutMs)));
    }
    SimResult result = builder.build().run();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.results().values())
        .containsExactly(
            List.of(TubeFailure.DEADLINE), List.of(TubeFailure.NONE), List.of(TubeFailure.NONE));
  }

  @Test
  void withoutAMajorityNoRobotMovesAndAllFail() {
    int robots = 4;
    TubeSettings hasty = new TubeSettings(60, 1_000, 10_000, 200, 2_000, 200, 2_000);
    Simulation.Builder builder = ring(7, weather("0", "0mm"));
    for (int i = 0; i < robots; i++) {
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              onRing(i, robots),
              true,
              gvh -> new Traveller(gvh, hasty, 1)));
    }
    builder.director(control -> {
      control.crash(new RobotId("bot2"));
      control.crash(new RobotId("bot3"));
    });
    SimResult result = builder.build().run();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(countOf(result, "FAIL DEADLINE")).isEqualTo(2);
  }

  @Test
  void aRobotThatWaitsForRoomPlansOnce() {
    List<PlanTask> planned = new ArrayList<>();
    Simulation.Builder builder =
        ring(3, weather("0", "0mm").toBuilder().set("headingNoise", "0deg").build());
    for (int i = 0; i < 2; i++) {
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i),
              new Pose(4000, 1000 + 4000 * i, 0),
              true,
              gvh -> new Waiter(gvh, planned)));
    }
    SimResult result = builder.build().run();
    assertHolds(result);
    assertThat(result.results().get(new RobotId("bot1"))).isEqualTo(List.of("DEADLINE"));
    // Around the other's tube, and without it.
    assertThat(planned).hasSize(2).doesNotHaveDuplicates();
  }

  /** The second robot wants the place where the first one stands. */
  private static final class Waiter extends LogicThread {
    private final List<PlanTask> planned;

    Waiter(GlobalVarHolder gvh, List<PlanTask> planned) {
      super(gvh);
      this.planned = planned;
    }

    @Override
    public List<Object> callStarL() {
      TubeSettings patient = new TubeSettings(60, 1_000, 20_000, 200, 2_000, 200, 2_000);
      PathPlanner recorded =
          task -> {
            planned.add(task);
            return new OptimalPlanner().plan(task);
          };
      DistributedPathPlanning paths =
          new DistributedPathPlanning(
              gvh, "floor", gvh.id.participants(), recorded, FLOOR, patient);
      await(gvh.gps::hasFix);
      sleep(1_000);
      if (!gvh.id.name().equals(new RobotId("bot1"))) {
        sleep(30_000);
        return List.of();
      }
      paths.goTo(new ItemPosition("taken", 4000, 1000));
      await(() -> !paths.isUnderWay());
      return List.of(paths.failure().get().toString());
    }
  }

  /** A planted bug: the robot requests a tube, but then drives straight to its goal. */
  @Test
  void aRobotThatLeavesItsTubeIsCaught() {
    Simulation.Builder builder = ring(3, weather("0", "0mm"));
    builder.robot(
        new RobotSpec(new RobotId("bot0"), new Pose(4000, 1000, 0), true, ShortCutter::new));
    SimResult result = builder.build().run();
    assertThat(result.spec().violations("tubes.Inside")).isPositive();
  }

  /** A planted bug: the planner never returns. */
  @Test
  void aRobotThatNeverTellsIsCaught() {
    Simulation.Builder builder = ring(3, weather("0", "0mm"));
    builder.robot(
        new RobotSpec(new RobotId("bot0"), new Pose(4000, 1000, 0), true, NeverTold::new));
    SimResult result = builder.build().run();
    assertThat(result.spec().violations("tubes.Told")).isPositive();
  }

  private static final class NeverTold extends LogicThread {
    NeverTold(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      TubeGoal goal = new TubeGoal.Place(new ItemPosition("goal", 4000, 7000));
      gvh.trace.action(
          Instance.of(TubeFact.PRIMITIVE, "floor"), TubeFact.SHAPE, new TubeFact.goTo(goal));
      await(() -> false);
      return List.of();
    }
  }

  private static final class ShortCutter extends LogicThread {
    ShortCutter(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths =
          new DistributedPathPlanning(gvh, "floor", new OptimalPlanner(), FLOOR);
      await(gvh.gps::hasFix);
      paths.goTo(new ItemPosition("goal", 4000, 7000));
      await(() -> paths.tubeflag().get() == TubeFlag.MOVING);
      gvh.plat.moat.doMove(new ItemPosition("goal", 3000, 7000));
      sleep(20_000);
      return List.of();
    }
  }

  @Test
  void equalSeedsGiveEqualRuns() {
    assertThat(crossing(5)).isEqualTo(crossing(5)).isNotEqualTo(crossing(6));
  }

  /** The number of events of a run, and its end. */
  private static List<Long> crossing(long seed) {
    Simulation.Builder builder = ring(seed, weather("0.2", "10mm"));
    for (int i = 0; i < 3; i++) {
      builder.robot(
          new RobotSpec(
              new RobotId("bot" + i), onRing(i, 3), true, gvh -> new Crosser(gvh, PATIENT)));
    }
    SimResult result = builder.build().run();
    return List.of(result.events(), result.endNs());
  }

  private static void assertHolds(SimResult result) {
    assertThat(result.spec().violations()).isEmpty();
    for (String lemma : List.of("tubes.Tubes", "tubes.Inside", "tubes.Told")) {
      assertThat(result.spec().checks(lemma)).as(lemma).isPositive();
    }
  }

  private static long countOf(SimResult result, String end) {
    long count = 0;
    for (Map.Entry<RobotId, List<Object>> ends : result.results().entrySet()) {
      count += ends.getValue().stream().filter(end::equals).count();
    }
    return count;
  }
}
