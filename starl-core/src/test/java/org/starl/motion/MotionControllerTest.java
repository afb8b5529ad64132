package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.body.Bumps;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Circle;
import org.starl.geometry.Fix;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.testing.FakePlatform;
import org.starl.testing.FakeWorld;
import org.starl.trace.TraceEvent;

/** plat.moat and gvh.gps over the ports. */
class MotionControllerTest {

  private static final ItemPosition AHEAD = new ItemPosition("ahead", 1000, 0);
  private static final ItemPosition BEHIND = new ItemPosition("behind", -1000, 0);

  private final FakeWorld world = new FakeWorld("bot0");
  private final FakePlatform robot = world.boot("bot0");
  private final GlobalVarHolder gvh = new GlobalVarHolder(robot.platform(), 1);
  private final MotionController moat = gvh.plat.moat;

  private void fix(double x, double y, double headingRad) {
    robot.fix(new Fix(new Pose(x, y, headingRad), world.nowNs(), 4, 0));
    world.runMs(0);
  }

  private WheelCommand last() {
    return robot.driven.get(robot.driven.size() - 1);
  }

  private List<String> traced() {
    return world.trace.stream()
        .map(event ->
            switch (event) {
              case TraceEvent.Action action -> action.name();
              case TraceEvent.Variable variable -> variable.name() + "=" + variable.value();
              default -> event.toString();
            })
        .toList();
  }

  @Test
  void drivingByCommandCancelsTheMotion() {
    fix(0, 0, 0);
    moat.doMove(AHEAD);
    WheelCommand arc = new WheelCommand(120, 0.5);
    moat.doDrive(arc);
    assertThat(last()).isEqualTo(arc);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.IDLE);
    assertThat(moat.target().get()).isInstanceOf(MotionTask.None.class);
    int before = robot.driven.size();
    world.runMs(1000);
    assertThat(robot.driven).as("no step of the cancelled motion").hasSize(before);
    moat.doDrive(arc);
    assertThat(robot.driven).as("repeated for the watchdog").hasSize(before + 1);
    assertThat(traced()).containsOnlyOnce("doDrive");
    fix(0, 0, 0);
    double startMm = gvh.gps.pose().xMm();
    world.runMs(100);
    assertThat(gvh.gps.pose().xMm() - startMm).isBetween(11.0, 12.0);
  }

  @Test
  void aCommandThatEndsAFailureIsRecordedThoughTheWheelsStand() {
    fix(0, 0, 0);
    moat.doMove(AHEAD, new Circle(AHEAD.at(), 100));
    assertThat(moat.failed()).isTrue();
    moat.doDrive(WheelCommand.STOP);
    assertThat(traced()).endsWith("doDrive", "(target, avoid)=none", "motionflag=IDLE");
  }

  @Test
  void aFixCountsFromTheReactionTimeAfterTheStartAndNotBefore() {
    FakeWorld late = new FakeWorld("bot0");
    FakePlatform bot = late.boot("bot0");
    MotionParameters parameters = MotionParameters.builder().reactionMs(100).build();
    GlobalVarHolder program = new GlobalVarHolder(bot.platform(parameters), 1);
    late.runMs(99);
    bot.fix(new Fix(new Pose(0, 0, 0), late.nowNs(), 4, 0));
    late.runMs(0);
    assertThat(program.gps.hasFix()).as("its wheels may still turn").isFalse();
    late.runMs(1);
    bot.fix(new Fix(new Pose(0, 0, 0), late.nowNs(), 4, 0));
    late.runMs(0);
    assertThat(program.gps.hasFix()).isTrue();
  }

  @Test
  void aStartingProgramStopsTheWheels() {
    assertThat(robot.driven).containsExactly(WheelCommand.STOP);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.IDLE);
    assertThat(moat.inMotion()).isFalse();
  }

  @Test
  void doMoveDrivesAtOnceAndArrives() {
    fix(900, 0, 0);
    moat.doMove(AHEAD);
    assertThat(moat.inMotion()).isTrue();
    assertThat(last().linearMmPerS()).isBetween(175.0, 250.0);
    world.runMs(100);
    assertThat(moat.inMotion()).isTrue();
    fix(930, 0, 0);
    world.runMs(60);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.DONE);
    assertThat(traced()).containsSubsequence("arrived", "motionflag=DONE");
    assertThat(moat.inMotion()).isFalse();
    assertThat(last()).isEqualTo(WheelCommand.STOP);
  }

  @Test
  void eachStepRepeatsTheCommandToTheChassis() {
    fix(0, 0, 0);
    moat.doMove(new ItemPosition("far", 9000, 0));
    world.runMs(240);
    assertThat(robot.driven).hasSize(6).endsWith(new WheelCommand(250, 0));
    assertThat(robot.driven.subList(1, 6)).containsOnly(new WheelCommand(250, 0));
  }

  @Test
  void aTargetWithinReachIsDoneAtOnce() {
    fix(960, 0, 0);
    moat.doMove(AHEAD);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void aNewTargetReplacesTheOldOneWhateverItsName() {
    fix(0, 0, 0);
    moat.doMove(AHEAD);
    moat.doMove(new ItemPosition("ahead", -1000, 0));
    assertThat(last().linearMmPerS()).isZero();
    assertThat(Math.abs(last().angularRadPerS())).isPositive();
    assertThat(moat.target().get())
        .isEqualTo(new MotionTask.GoTo(new ItemPosition("ahead", -1000, 0), new Nowhere()));
  }

  @Test
  void aBumpStopsAtOnceAndFails() {
    fix(0, 0, 0);
    moat.doMove(AHEAD);
    world.runMs(10);
    robot.bump(Bumps.BOTH);
    world.runMs(0);
    assertThat(last()).isEqualTo(WheelCommand.STOP);
    assertThat(moat.failed()).isTrue();
    assertThat(moat.failure()).isEqualTo("bumped into something");
    assertThat(traced()).containsSubsequence("failed", "motionflag=FAIL");
    assertThat(gvh.gps.knownObstacles().all().distanceMm(new Point(167.5, 0))).isLessThan(1);
    assertThat(gvh.gps.knownObstacles().contacts()).isEqualTo(1);
  }

  @Test
  void aContactWidensTheErrorBoundAlsoIfTheCommandStays() {
    fix(0, 0, 0);
    moat.setParameters(
        moat.parameters().toBuilder().collisionPolicy(CollisionPolicy.BUMPERCARS).build());
    moat.doMove(new ItemPosition("far", 9000, 0));
    world.runMs(10);
    robot.bump(Bumps.BOTH);
    world.runMs(0);
    double beforeMm = gvh.gps.errorMm();
    world.runMs(40);
    // It drives 10 mm, and may slide as far in any direction.
    assertThat(gvh.gps.errorMm() - beforeMm).isGreaterThan(19);
  }

  @Test
  void theErrorBoundAllowsForWheelsThatReactAsLateAsTheParametersSay() {
    fix(0, 0, 0);
    moat.setParameters(moat.parameters().toBuilder().reactionMs(300).build());
    moat.doMove(new ItemPosition("far", 9000, 0));
    world.runMs(120);
    moat.motion_stop();
    double beforeMm = gvh.gps.errorMm();
    world.runMs(200);
    // It may have driven on for 50 mm.
    assertThat(gvh.gps.errorMm() - beforeMm).isGreaterThan(49);
  }

  @Test
  void aSensorThatOpensWaitsForTheNextStep() {
    fix(0, 0, 0);
    moat.setParameters(
        moat.parameters().toBuilder().collisionPolicy(CollisionPolicy.BUMPERCARS).build());
    moat.doMove(AHEAD);
    world.runMs(10);
    robot.bump(Bumps.BOTH);
    world.runMs(0);
    int steps = robot.driven.size();
    robot.bump(Bumps.NONE);
    world.runMs(0);
    assertThat(robot.driven).hasSize(steps);
    world.runMs(60);
    assertThat(robot.driven).hasSizeGreaterThan(steps);
  }

  @Test
  void afterAFailureTheNextMotionStartsAnew() {
    fix(0, 0, 0);
    moat.doMove(AHEAD);
    robot.bump(Bumps.BOTH);
    world.runMs(0);
    robot.bump(Bumps.NONE);
    world.runMs(0);
    moat.doMove(BEHIND);
    assertThat(moat.inMotion()).isTrue();
    assertThat(moat.failure()).isEmpty();
  }

  @Test
  void motionStopStopsAndCancels() {
    fix(0, 0, 0);
    moat.doMove(AHEAD);
    moat.motion_stop();
    assertThat(last()).isEqualTo(WheelCommand.STOP);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.IDLE);
    assertThat(moat.target().get()).isEqualTo(new MotionTask.None());
    int driven = robot.driven.size();
    world.runMs(500);
    assertThat(robot.driven).hasSize(driven);
  }

  @Test
  void aRobotThatIsPushedAfterAStopDoesNotDriveOn() {
    fix(0, 0, 0);
    moat.doMove(AHEAD);
    moat.motion_stop();
    robot.bump(Bumps.LEFT);
    world.runMs(500);
    assertThat(last()).isEqualTo(WheelCommand.STOP);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.IDLE);
  }

  @Test
  void commandsAndFlagsAreTraced() {
    fix(0, 0, 0);
    moat.doMove(AHEAD, new Circle(new Point(0, 900), 10));
    moat.motion_stop();
    assertThat(traced())
        .containsSubsequence(
            "doMove",
            "(target, avoid)=(ahead@1000.0,0.0, circle(0.0 900.0 10.0))",
            "motionflag=MOVING",
            "motion_stop",
            "(target, avoid)=none",
            "motionflag=IDLE");
  }

  @Test
  void newParametersApplyToTheNextMotion() {
    fix(0, 0, 0);
    moat.setParameters(moat.parameters().toBuilder().linSpeedMaxMmPerS(400).build());
    moat.doMove(new ItemPosition("far", 9000, 0));
    assertThat(last()).isEqualTo(new WheelCommand(400, 0));
  }

  @Test
  void turnToTurnsOnTheSpot() {
    fix(0, 0, StrictMath.PI / 2 - 0.2);
    moat.turnTo(new ItemPosition("left", 0, 1000));
    assertThat(last().linearMmPerS()).isZero();
    assertThat(last().angularRadPerS()).isPositive();
    world.runMs(59);
    fix(0, 0, StrictMath.PI / 2 - 0.1);
    world.runMs(60);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.MOVING);
    fix(0, 0, StrictMath.PI / 2 - 0.04);
    world.runMs(60);
    assertThat(moat.motionflag().get()).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void theLocationIsUnknownBeforeTheFirstFix() {
    assertThat(gvh.gps.currentlocation().get()).isEqualTo(new Location.Unknown());
    assertThat(gvh.gps.mypos().get()).isEqualTo(new Location.Unknown());
    assertThat(gvh.gps.hasFix()).isFalse();
    assertThat(gvh.gps.errorMm()).isInfinite();
    assertThat(gvh.gps.isClearOf(new Circle(new Point(0, 0), 1), 165)).isFalse();
    assertThatThrownBy(gvh.gps::pose).isInstanceOf(IllegalStateException.class);
    assertThat(gvh.variables()).contains(gvh.gps.currentlocation());
  }

  @Test
  void clearanceNeedsMoreThanTheErrorBound() {
    Region zone = Rectangle.around(new Point(0, 0), 500, 500);
    fix(418, 0, 0);
    assertThat(gvh.gps.clearanceMm(zone, 165)).isEqualTo(-1);
    assertThat(gvh.gps.isClearOf(zone, 165)).isFalse();
    fix(423, 0, 0);
    assertThat(gvh.gps.errorMm()).isLessThanOrEqualTo(4);
    assertThat(gvh.gps.isClearOf(zone, 165)).isTrue();
    assertThat(gvh.gps.maxDistanceMm(new Point(0, 0))).isGreaterThan(423);
    assertThat(gvh.gps.minDistanceMm(new Point(0, 0))).isLessThan(423);
  }

  @Test
  void clearanceShrinksWhileTheRobotMovesWithoutFixes() {
    fix(500, 0, 0);
    Region zone = Rectangle.around(new Point(0, 0), 500, 500);
    moat.doMove(new ItemPosition("far", 9000, 0));
    double before = gvh.gps.clearanceMm(zone, 165);
    world.runMs(50);
    // Farther by its path if it drove, no farther if it was held up: the bound takes the latter.
    assertThat(gvh.gps.clearanceMm(zone, 165)).isEqualTo(before);
    assertThat(gvh.gps.ageNs()).isEqualTo(50_000_000);
  }

  @Test
  void aFixFromTheReactionTimeAfterARestartIsNotUsed() {
    FakeWorld elsewhere = new FakeWorld("bot1");
    FakePlatform late = elsewhere.boot("bot1");
    MotionParameters lateWheels = MotionParameters.builder().reactionMs(50).build();
    Gps gps = new GlobalVarHolder(late.platform(lateWheels), 1).gps;
    late.fix(new Fix(new Pose(0, 0, 0), 49_000_000, 4, 0));
    elsewhere.runMs(60);
    assertThat(gps.hasFix()).isFalse();
    late.fix(new Fix(new Pose(0, 0, 0), 50_000_000, 4, 0));
    elsewhere.runMs(0);
    assertThat(gps.hasFix()).isTrue();
    assertThat(gps.fixes()).isEqualTo(2);
  }

  @Test
  void fixesAreNotTraced() {
    int[] heard = {0};
    gvh.gps.onFix(() -> heard[0]++);
    fix(0, 0, 0);
    fix(1, 0, 0);
    assertThat(traced()).noneMatch(line -> line.startsWith("currentlocation"));
    assertThat(heard[0]).isEqualTo(2);
    assertThat(gvh.gps.fixes()).isEqualTo(2);
  }
}
