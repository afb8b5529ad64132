package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.MotionStyle;
import org.starl.body.RobotType;
import org.starl.body.WheelCommand;
import org.starl.geometry.Fix;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.random.Rng;

/** A motion that cannot be done says so; nothing else counts as an arrival. */
class MotionRunTest {

  private static final Point TARGET = new Point(3000, 0);

  private static MotionWorld world() {
    return new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
  }

  @Test
  void aWallWithoutABumpFailsForLackOfProgress() {
    MotionWorld world = world();
    world.wallMm = 800;
    world.bumpSensorsWork = false;
    assertThat(world.goTo(TARGET, new Nowhere(), 60_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.NO_PROGRESS);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    assertThat(world.seconds()).isLessThan(10);
  }

  @Test
  void aWallWithABumpFailsAtOnce() {
    MotionWorld world = world();
    world.wallMm = 800;
    assertThat(world.goTo(TARGET, new Nowhere(), 60_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.BUMPED);
    assertThat(world.seconds()).isLessThan(3);
  }

  @Test
  void aRobotBacksOffAsFarAsItMay() {
    MotionParameters parameters =
        MotionParameters.builder().collisionPolicy(CollisionPolicy.USE_COLBACK).build();
    double bodyMm = parameters.robotRadiusMm();
    double contactMm = 800 - bodyMm;
    for (double roomMm : new double[] {0, 40, 1000}) {
      MotionWorld world = new MotionWorld(1, parameters, new Pose(0, 0, 0));
      world.wallMm = 800;
      double borderMm = contactMm - bodyMm - roomMm;
      world.retreatAvoid = () -> new Rectangle(-2000, -2000, borderMm, 2000);
      assertThat(world.goTo(TARGET, new Nowhere(), 60_000)).isEqualTo(MotionFlag.FAIL);
      assertThat(world.run().failure()).isEqualTo(MotionFailure.BUMPED);
      double backMm = contactMm - world.truth.xMm();
      assertThat(backMm).as("room %s", roomMm).isBetween(Math.min(20, roomMm), roomMm);
      assertThat(backMm).isLessThan(110);
    }
  }

  @Test
  void eachRetreatAsksAnewForTheRegionToAvoid() {
    MotionParameters parameters =
        MotionParameters.builder()
            .collisionPolicy(CollisionPolicy.USE_COLBACK)
            .robotType(RobotType.DISCOVERY)
            .build();
    MotionWorld world = new MotionWorld(1, parameters, new Pose(0, 0, 0));
    world.wallMm = 800;
    AtomicInteger asked = new AtomicInteger();
    world.retreatAvoid =
        () -> {
          asked.incrementAndGet();
          return new Rectangle(-9000, -9000, -8000, 9000);
        };
    world.begin(TARGET, new Nowhere());
    int retreats = 0;
    while (retreats < 2 && world.seconds() < 60) {
      boolean wasBackingOff = world.command.linearMmPerS() < 0;
      world.tick();
      retreats += world.command.linearMmPerS() < 0 && !wasBackingOff ? 1 : 0;
    }
    assertThat(retreats).isEqualTo(2);
    assertThat(asked).hasValue(2);
  }

  @Test
  void stuckWheelsFail() {
    MotionWorld world = world();
    world.mobility = 0;
    world.noiseMm = 20;
    assertThat(world.goTo(TARGET, new Nowhere(), 60_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.NO_PROGRESS);
  }

  @Test
  void theWheelsStopWhenTheFixIsOlderThanItMayBeAndNotBefore() {
    MotionWorld world = world();
    world.begin(TARGET, new Nowhere());
    world.runFor(1_000);
    world.fixesCome = false;
    long ageMs = world.parameters.maxFixAgeMs();
    world.runFor(ageMs - 100);
    assertThat(world.command).isNotEqualTo(WheelCommand.STOP);
    world.runFor(200);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
  }

  @Test
  void theWheelsStopWhenThePositionIsLessCertainThanItMustBeAndNotBefore() {
    MotionParameters p = MotionParameters.DEFAULT;
    double mostMm = p.maxErrorMm();
    assertThat(firstCommand(p, mostMm)).isNotEqualTo(WheelCommand.STOP);
    assertThat(firstCommand(p, Math.nextUp(mostMm))).isEqualTo(WheelCommand.STOP);
  }

  private static WheelCommand firstCommand(MotionParameters p, double errorMm) {
    return MotionRun.goTo(TARGET, new Nowhere(), Nowhere::new, p, new Rng(1), 0)
        .step(
            new Location.Known(new Pose(0, 0, 0), errorMm, 0, 0, 0),
            false,
            Bumps.NONE,
            LingeringSpeeds.NONE,
            0);
  }

  @Test
  void aWaitForFixesIsNoTimeWithoutProgress() {
    MotionWorld world = world();
    world.mobility = 0;
    world.begin(TARGET, new Nowhere());
    world.runFor(1_500);
    world.fixesCome = false;
    world.runFor(1_900);
    world.fixesCome = true;
    world.runFor(2_600);
    assertThat(world.run().status()).isEqualTo(MotionFlag.MOVING);
    world.runFor(1_500);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.NO_PROGRESS);
  }

  @Test
  void stuckWheelsFailATurnToo() {
    MotionWorld world = world();
    world.mobility = 0;
    assertThat(world.goTo(new Point(-3000, 0), new Nowhere(), 60_000)).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void aRobotThatIsTooSlowFailsInTheEnd() {
    MotionWorld world = world();
    world.mobility = 0.08;
    long longestMs = world.parameters.longestMs(3000);
    assertThat(world.goTo(TARGET, new Nowhere(), longestMs - 100)).isEqualTo(MotionFlag.MOVING);
    world.idle(200);
    assertThat(world.run().status()).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.TOO_SLOW);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
  }

  @Test
  void aSlowRobotThatIsInTimeArrives() {
    MotionWorld world = world();
    world.mobility = 0.3;
    assertThat(world.goTo(TARGET, new Nowhere(), 60_000)).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void aContradictionStopsTheWheelsAndIsNamedWhenTheMotionFails() {
    MotionWorld world = world();
    world.begin(TARGET, new Nowhere());
    world.runFor(1_000);
    assertThat(world.command.isStop()).isFalse();
    world.filter.fixed(new Fix(new Pose(2000, 0, 0), world.nowNs, 1, 0), world.nowNs);
    world.fixesCome = false;
    world.runFor(60);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    assertThat(world.run().status()).isEqualTo(MotionFlag.MOVING);
    world.runFor(2_000);
    assertThat(world.run().status()).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.CONTRADICTED);
  }

  @Test
  void aRobotThatIsHeldElsewhereFailsAsContradictedNotAsWithoutFixes() {
    MotionWorld world = world();
    world.begin(TARGET, new Nowhere());
    world.runFor(1_000);
    // A contradiction within the greatest error of a position: only the age of the fix stops it.
    Pose aside = new Pose(world.truth.xMm(), world.truth.yMm() + 100, 0);
    world.fixesCome = false;
    world.filter.fixed(new Fix(aside, world.nowNs, 1, 0), world.nowNs);
    world.runFor(5_000);
    assertThat(world.run().status()).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.CONTRADICTED);
  }

  @Test
  void anUncertainPositionStopsTheWheelsAndThenFails() {
    MotionWorld world = world();
    world.fixesCome = false;
    world.filter.fixed(new Fix(world.truth, 0, 1_000, 0), 0);
    world.begin(TARGET, new Nowhere());
    world.runFor(5_000);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.UNCERTAIN);
  }

  @Test
  void aJumpOnlyInterruptsTheMotion() {
    MotionWorld world = world();
    world.noiseMm = 10;
    world.jumps = 0.2;
    assertThat(world.goTo(TARGET, new Nowhere(), 60_000)).isEqualTo(MotionFlag.DONE);
    assertThat(world.filter.contradictions()).isPositive();
    assertThat(world.truth.distanceMm(TARGET)).isLessThan(75 + 10 + 1e-6);
  }

  @Test
  void aRobotThatNeverComesNearerFails() {
    MotionParameters parameters =
        MotionParameters.builder()
            .collisionPolicy(CollisionPolicy.USE_COLBACK)
            .robotType(RobotType.RANDOM_MOVER)
            .build();
    MotionWorld world = new MotionWorld(3, parameters, new Pose(0, 0, 0));
    world.wallMm = 800;
    assertThat(world.goTo(TARGET, new Nowhere(), 300_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.BUMPED);
  }

  @Test
  void withoutFixesTheWheelsStopAndThenTheMotionFails() {
    MotionWorld world = world();
    world.begin(TARGET, new Nowhere());
    world.runFor(2_000);
    world.fixesCome = false;
    world.runFor(400);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    assertThat(world.run().status()).isEqualTo(MotionFlag.MOVING);
    world.runFor(2_000);
    assertThat(world.run().status()).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.NO_FIX);
  }

  @Test
  void aShortOutageOnlyDelaysTheArrival() {
    MotionWorld world = world();
    world.begin(TARGET, new Nowhere());
    world.runFor(2_000);
    world.fixesCome = false;
    world.runFor(1_500);
    world.fixesCome = true;
    assertThat(world.runFor(30_000)).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void withoutAnyFixItWaitsAndFails() {
    MotionWorld world = world();
    world.fixesCome = false;
    world.begin(TARGET, new Nowhere());
    assertThat(world.runFor(1_900)).isEqualTo(MotionFlag.MOVING);
    assertThat(world.truth).isEqualTo(new Pose(0, 0, 0));
    assertThat(world.runFor(1_000)).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void aRobotThatDrivesOnThroughItsTargetStopsAtABump() {
    MotionParameters parameters = MotionParameters.builder().stopAtDestination(false).build();
    MotionWorld world = new MotionWorld(1, parameters, new Pose(0, 0, 0));
    world.wallMm = 2000;
    assertThat(world.goTo(new Point(1000, 0), new Nowhere(), 20_000)).isEqualTo(MotionFlag.DONE);
    assertThat(world.command.linearMmPerS()).isPositive();
    assertThat(world.run().needsSteps()).isTrue();
    for (int i = 0; i < 300; i++) {
      world.tick();
    }
    assertThat(world.truth.xMm()).isGreaterThan(1500);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    assertThat(world.run().status()).isEqualTo(MotionFlag.DONE);
    assertThat(world.run().needsSteps()).isFalse();
  }

  private static final Region IN_THE_WAY = new Rectangle(1000, -200, 1200, 200);

  private static MotionWorld onWayOf(WayPlanner planner) {
    MotionWorld world = world();
    world.begin(TARGET, IN_THE_WAY);
    world.run().onWayOf(planner);
    return world;
  }

  @Test
  void itStandsUntilItsWayIsPlannedAndDrivesOnIt() {
    List<Point> way = List.of(new Point(900, 600), new Point(1300, 600), TARGET);
    AtomicReference<List<Point>> plan = new AtomicReference<>();
    MotionWorld world = onWayOf(from -> plan::get);
    assertThat(world.runFor(1000)).isEqualTo(MotionFlag.MOVING);
    assertThat(world.truth).isEqualTo(new Pose(0, 0, 0));
    plan.set(way);
    assertThat(world.runFor(60_000)).isEqualTo(MotionFlag.DONE);
    assertThat(world.truth.distanceMm(TARGET)).isLessThan(MotionParameters.DEFAULT.goalRadiusMm());
    assertThat(world.nearestToAvoidMm).isGreaterThan(MotionParameters.DEFAULT.robotRadiusMm());
  }

  @Test
  void withoutAWayItFailsWhereItStands() {
    MotionWorld world = onWayOf(from -> List::of);
    assertThat(world.runFor(1000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.NO_WAY);
    assertThat(world.truth).isEqualTo(new Pose(0, 0, 0));
  }

  @Test
  void aWayThroughTheRegionIsPlannedAnewAndThenFails() {
    List<Location.Known> starts = new ArrayList<>();
    MotionWorld world =
        onWayOf(from -> {
          starts.add(from);
          return () -> List.of(TARGET);
        });
    assertThat(world.runFor(60_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.IN_THE_WAY);
    assertThat(starts).hasSize(4);
    assertThat(starts.getLast().pose().xMm()).isGreaterThan(500);
  }

  @Test
  void afterAManeuverTheWayIsPlannedAnew() {
    MotionParameters turns =
        MotionParameters.builder().collisionPolicy(CollisionPolicy.USE_COLAVOID).build();
    MotionWorld world = new MotionWorld(1, turns, new Pose(0, 0, 0));
    world.wallMm = 800;
    world.begin(TARGET, new Nowhere());
    List<Location.Known> starts = new ArrayList<>();
    world
        .run()
        .onWayOf(from -> {
          starts.add(from);
          return () -> List.of(new Point(1500, 0), TARGET);
        });
    assertThat(world.runFor(600_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(starts).hasSize(4);
  }

  @Test
  void aLongWayHasTheTimeForItsLength() {
    Point far = new Point(0, 20_000);
    MotionWorld world = onWayOf(from -> () -> List.of(far, new Point(3000, 20_000), TARGET));
    assertThat(world.runFor(600_000)).isEqualTo(MotionFlag.DONE);
    double longestS = MotionParameters.DEFAULT.longestMs(TARGET.normMm()) / 1e3;
    assertThat(world.seconds()).isGreaterThan(longestS);
  }

  @Property(tries = 200)
  void equalInputsGiveEqualCommands(@ForAll long seed) {
    assertThat(commands(seed)).isEqualTo(commands(seed));
  }

  /** What a motion commands in a world that makes no sense: any poses, bumps and times. */
  private static List<String> commands(long seed) {
    Rng rng = new Rng(seed);
    MotionParameters parameters =
        MotionParameters.builder()
            .style(rng.nextBoolean(0.3) ? MotionStyle.IDEAL : MotionStyle.UNICYCLE)
            .collisionPolicy(CollisionPolicy.values()[rng.nextInt(4)])
            .robotType(RobotType.values()[rng.nextInt(3)])
            .build();
    MotionRun run =
        MotionRun.goTo(
            new Point(900, 900), new Nowhere(), Nowhere::new, parameters, rng.fork("moat"), 0);
    List<String> commands = new ArrayList<>();
    long nowNs = 0;
    for (int i = 0; i < 200; i++) {
      Pose pose =
          new Pose(1000 * rng.nextDouble(), 1000 * rng.nextDouble(), 6 * rng.nextDouble() - 3);
      Location location =
          rng.nextBoolean(0.05)
              ? new Location.Unknown()
              : new Location.Known(pose, 5, 0.01, nowNs, nowNs);
      Bumps bumps = rng.nextBoolean(0.1) ? Bumps.values()[rng.nextInt(4)] : Bumps.NONE;
      commands.add(
          run.step(location, false, bumps, LingeringSpeeds.NONE, nowNs)
              + " "
              + run.status()
              + " "
              + run.state());
      nowNs += rng.nextLong(1, 100_000_000);
    }
    return commands;
  }
}
