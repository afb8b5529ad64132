package org.starl.primitives.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.geometry.Circle;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.motion.MotionTask;
import org.starl.random.Rng;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** Motion control on simulated robots; each run is checked by the specification. */
class MotionControlTest {

  private static final int SEEDS = 15;
  private static final String THEORY = MotionControlAutomaton.MOTION_CONTROL_DECLS;

  /** A world determined by a seed. */
  private static SimSettings drawn(long seed, CollisionPolicy policy) {
    Rng rng = new Rng(seed).fork("world");
    boolean isIdeal = rng.nextBoolean(0.25);
    // In ideal motion bodies do not bump, so robots that react to bumps are refused.
    String ofEachType = isIdeal ? "0" : "1";
    return SimSettings.builder()
        .robots(4)
        .set("randomRobots", ofEachType)
        .set("discoveryRobots", ofEachType)
        .set("collisionPolicy", policy.name())
        .set("idealMotion", isIdeal ? "true" : "false")
        .set("positionPeriod", rng.nextLong(20, 250) + "ms")
        .set("positionNoise", rng.nextLong(0, 60) + "mm")
        .set("headingNoise", rng.nextLong(0, 15) + "deg")
        .set("speedError", rng.nextBoolean(0.3) ? "0" : "0." + rng.nextLong(0, 4))
        .set("duration", "3000s")
        .build();
  }

  private static Simulation.Builder simulation(long seed, SimSettings settings) {
    MotionParameters parameters = settings.motionParameters(0);
    return Simulation.builder()
        .seed(seed)
        .settings(settings)
        .monitor(() -> new MotionSpec(parameters, 200))
        .monitor(() -> new MotionConformance(parameters));
  }

  @ParameterizedTest
  @EnumSource(CollisionPolicy.class)
  void theContractHoldsInAnyWorldWithinTheEnvelope(CollisionPolicy policy) {
    Map<MotionFlag, Integer> ends = new EnumMap<>(MotionFlag.class);
    long arrivals = 0;
    for (long seed = 1; seed <= SEEDS; seed++) {
      SimSettings settings = drawn(seed, policy);
      SimResult result = simulation(seed, settings).robots(4, Driver::new).build().run();
      assertThat(result.spec().violations())
          .as("%s, seed %s, %s", policy, seed, settings)
          .isEmpty();
      assertThat(result.isFinished()).isTrue();
      arrivals += result.spec().checks(MotionSpec.ARRIVES);
      result
          .results()
          .values()
          .forEach(flags -> flags.forEach(flag -> ends.merge((MotionFlag) flag, 1, Integer::sum)));
    }
    assertThat(ends.get(MotionFlag.DONE)).isGreaterThan(30);
    assertThat(ends.get(MotionFlag.FAIL)).isGreaterThan(30);
    assertThat(arrivals).isGreaterThan(10);
  }

  private static final ItemPosition AHEAD = new ItemPosition("ahead", 2000, 0);

  /** One robot at the origin, heading to AHEAD, on a floor with or without a wall. */
  private static SimResult one(Obstacles obstacles, CollisionPolicy policy, Consumer<Robot> app) {
    SimSettings settings =
        SimSettings.builder().set("collisionPolicy", policy.name()).set("duration", "400s").build();
    return simulation(1, settings)
        .obstacles(obstacles)
        .robot(
            new RobotSpec(
                new RobotId("bot0"), new Pose(0, 0, 0), true, gvh -> new OneCall(gvh, app)))
        .build()
        .run();
  }

  /** The parameters of an app with one call. */
  private record Robot(GlobalVarHolder gvh, MotionPrim mc) {
    MotionFlag await() {
      gvh.plat.strand.awaitUntil(() -> mc.motionflag().get() != MotionFlag.MOVING, Long.MAX_VALUE);
      return mc.motionflag().get();
    }

    void change(UnaryOperator<MotionParameters.Builder> how) {
      gvh.plat.moat.setParameters(how.apply(gvh.plat.moat.parameters().toBuilder()).build());
    }
  }

  private static final class OneCall extends LogicThread {
    private final Consumer<Robot> app;

    OneCall(GlobalVarHolder gvh, Consumer<Robot> app) {
      super(gvh);
      this.app = app;
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      app.accept(new Robot(gvh, new MotionControl(gvh)));
      return List.of();
    }
  }

  private static SimResult one(Consumer<Robot> app) {
    return one(Obstacles.NONE, CollisionPolicy.STOP_ON_COLLISION, app);
  }

  @Test
  void thePapersActionsBehaveAsInThePaper() {
    Region beyond = new Circle(new Point(4000, 0), 300);
    SimResult result =
        one(robot -> {
          robot.mc().do_move(AHEAD, beyond);
          assertThat(robot.mc().target().get()).isEqualTo(new MotionTask.GoTo(AHEAD, beyond));
          assertThat(robot.await()).isEqualTo(MotionFlag.DONE);
          assertThat(robot.mc().failed()).isFalse();
          robot.mc().gotopoint(new ItemPosition("back", 0, 0));
          assertThat(robot.mc().motionflag().get()).isEqualTo(MotionFlag.MOVING);
          robot.mc().motion_stop();
          assertThat(robot.mc().motionflag().get()).isEqualTo(MotionFlag.IDLE);
          assertThat(robot.mc().target().get()).isEqualTo(new MotionTask.None());
        });
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.spec().checks(MotionSpec.ARRIVES)).isEqualTo(1);
    assertThat(result.spec().checks(MotionSpec.AVOIDS)).isPositive();
    assertThat(result.spec().checks(MotionSpec.TOLD)).isEqualTo(1);
  }

  @Test
  void aTargetInTheRegionFailsAtOnce() {
    SimResult result =
        one(robot -> {
          robot.mc().do_move(AHEAD, new Circle(new Point(2000, 164), 0));
          assertThat(robot.mc().failed()).isTrue();
          assertThat(robot.mc().failure()).isEqualTo("the target is in the region to avoid");
        });
    assertThat(result.spec().violations()).isEmpty();
  }

  private static Region inTheWay(Rng rng) {
    Point at = new Point(900 + 200 * rng.nextDouble(), 200 * rng.nextDouble() - 100);
    double mm = 400 * rng.nextDouble();
    return switch (rng.nextInt(5)) {
      case 0 -> new Circle(at, mm);
      case 1 -> Rectangle.around(at, mm, 3 * mm);
      case 2 -> Rectangle.around(at, 0, 3 * mm);
      case 3 ->
          Polygon.of(
              at.plus(new Point(-mm, -mm)), at.plus(new Point(mm, -mm)), at.plus(new Point(0, mm)));
      default -> Union.of(new Circle(at, mm), new Circle(at.plus(new Point(0, 2 * mm)), mm));
    };
  }

  @Test
  void aRegionInTheWayIsPassed() {
    for (long seed = 1; seed <= 40; seed++) {
      Region region = inTheWay(new Rng(seed));
      SimResult result =
          one(robot -> {
            robot.mc().do_move(AHEAD, region);
            assertThat(robot.await()).as(region.toString()).isEqualTo(MotionFlag.DONE);
            robot.mc().gotopoint(new ItemPosition("back", 0, 0), region);
            assertThat(robot.await()).as(region.toString()).isEqualTo(MotionFlag.DONE);
          });
      assertThat(result.spec().violations()).as(region.toString()).isEmpty();
      assertThat(result.spec().checks(MotionSpec.AVOIDS)).isPositive();
    }
  }

  @Test
  void aRegionAllAroundFailsWithoutAMove() {
    Region ring =
        Union.of(
            new Rectangle(500, -1000, 600, 1000),
            new Rectangle(500, 900, 3000, 1000),
            new Rectangle(2900, -1000, 3000, 1000),
            new Rectangle(500, -1000, 3000, -900));
    SimResult result =
        one(robot -> {
          robot.mc().do_move(AHEAD, ring);
          assertThat(robot.mc().motionflag().get()).isEqualTo(MotionFlag.MOVING);
          assertThat(robot.await()).isEqualTo(MotionFlag.FAIL);
          assertThat(robot.mc().failure()).isEqualTo("no way to the target");
          assertThat(robot.gvh().gps.pose()).isEqualTo(new Pose(0, 0, 0));
        });
    assertThat(result.spec().violations()).isEmpty();
  }

  @Test
  void aKnownWallIsPassed() {
    SimResult result =
        one(
            WALL,
            CollisionPolicy.STOP_ON_COLLISION,
            robot -> {
              robot.mc().gotopoint(AHEAD);
              assertThat(robot.await()).isEqualTo(MotionFlag.DONE);
            });
    assertThat(result.spec().violations()).isEmpty();
  }

  @Test
  void itStopsAtARegionThatItPlansNoWayAround() {
    SimResult result =
        one(robot -> {
          robot.gvh().plat.moat.doMove(AHEAD, new Circle(new Point(1000, 0), 200));
          assertThat(robot.await()).isEqualTo(MotionFlag.FAIL);
          assertThat(robot.gvh().gps.pose().xMm()).isBetween(600.0, 635.0);
        });
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.spec().checks(MotionSpec.ARRIVES)).isZero();
  }

  private static final Obstacles WALL =
      Obstacles.NONE.plus(
          Obstacle.body(
              new Point(1000, -900),
              new Point(1100, -900),
              new Point(1100, 900),
              new Point(1000, 900)));

  /** The same, on no map. */
  private static final Obstacles HIDDEN_WALL =
      Obstacles.of(new Obstacle(WALL.all().get(0).points(), true, true, Obstacle.FOREVER));

  @Test
  void aRobotThatPushesAgainstAWallFailsAfterAWhile() {
    SimResult result =
        one(
            HIDDEN_WALL,
            CollisionPolicy.BUMPERCARS,
            robot -> {
              robot.mc().gotopoint(AHEAD);
              assertThat(robot.await()).isEqualTo(MotionFlag.FAIL);
              assertThat(robot.mc().failure()).isEqualTo("no progress");
            });
    assertThat(result.spec().violations()).isEmpty();
  }

  // Planted bugs: each lemma must find its bug.

  @Test
  void aRobotThatForgetsItsBodyIsSeenToEnter() {
    SimResult result =
        one(robot -> {
          robot.change(p -> p.robotRadiusMm(10));
          robot.mc().do_move(AHEAD, new Circle(new Point(1000, 0), 200));
          robot.await();
        });
    assertThat(result.spec().violations(MotionSpec.AVOIDS)).isEqualTo(1);
    assertThat(result.spec().violations(THEORY)).isEqualTo(1);
  }

  @Test
  void aRobotThatReportsDoneTooEarlyViolatesTold() {
    SimResult result =
        one(robot -> {
          robot.change(p -> p.goalRadiusMm(300));
          robot.mc().do_move(AHEAD, new Nowhere());
          robot.await();
        });
    assertThat(result.spec().violations(MotionSpec.TOLD)).isEqualTo(1);
    assertThat(result.spec().violations(THEORY)).isEqualTo(1);
  }

  @Test
  void aRobotThatNeverGivesUpIsSeenNotToTell() {
    SimResult result =
        one(
            HIDDEN_WALL,
            CollisionPolicy.BUMPERCARS,
            robot -> {
              robot.change(
                  p -> p.stuckAfterMs(1_000_000).noProgressMs(1_000_000).slowestMmPerS(0.1));
              robot.mc().gotopoint(AHEAD);
              robot.await();
            });
    assertThat(result.spec().violations(MotionSpec.TOLD)).isEqualTo(1);
  }

  /** The same error of its fixes, in their bound or beyond it. */
  @ParameterizedTest
  @CsvSource({"'noise(all,30mm)', 0", "'jump(all,30mm)', 1"})
  void aRobotIsWhereItBelievesToBeUnlessItsFixesAreWrong(String fault, int violations) {
    SimSettings settings =
        SimSettings.builder().robots(1).set("faults", fault).set("duration", "60s").build();
    SimResult result =
        Simulation.builder()
            .seed(1)
            .settings(settings)
            .monitor(() -> new MotionSpec(settings.motionParameters(0)).located())
            .robots(1, Driver::new)
            .build()
            .run();
    assertThat(result.spec().checks(MotionSpec.LOCATED)).isPositive();
    assertThat(result.spec().violations(MotionSpec.LOCATED)).isEqualTo(violations);
  }

  @Test
  void aRobotThatGivesUpTooEarlyIsSeenNotToArrive() {
    SimResult result =
        one(robot -> {
          robot.change(p -> p.stuckAfterMs(1));
          robot.mc().do_move(AHEAD, new Nowhere());
          robot.await();
        });
    assertThat(result.spec().violations(MotionSpec.ARRIVES)).isEqualTo(1);
  }
}
