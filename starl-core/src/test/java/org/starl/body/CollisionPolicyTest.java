package org.starl.body;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Angles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.motion.MotionAutomaton;
import org.starl.motion.MotionFlag;
import org.starl.motion.MotionState;
import org.starl.random.Rng;

/** The original StarL's collision modes; a collision that ends the motion is FAIL here. */
class CollisionPolicyTest {

  private static final Pose START = new Pose(0, 0, 0);
  private static final Point AHEAD = new Point(2000, 0);

  private long nowNs;

  private static MotionAutomaton automaton(CollisionPolicy policy, RobotType type, long seed) {
    MotionParameters parameters =
        MotionParameters.builder().collisionPolicy(policy).robotType(type).build();
    return MotionAutomaton.goTo(AHEAD, true, parameters, new Rng(seed));
  }

  private static MotionAutomaton automaton(CollisionPolicy policy) {
    return automaton(policy, RobotType.GOAL, 1);
  }

  private WheelCommand after(long ms, MotionAutomaton automaton, Pose pose, Bumps bumps) {
    nowNs += ms * 1_000_000;
    return automaton.step(pose, bumps, nowNs);
  }

  private static Pose facing(double degrees) {
    return new Pose(0, 0, Angles.fromDegrees(degrees));
  }

  @Test
  void bumpercarsDriveOn() {
    MotionAutomaton car = automaton(CollisionPolicy.BUMPERCARS);
    after(0, car, START, Bumps.NONE);
    assertThat(after(60, car, START, Bumps.BOTH)).isEqualTo(new WheelCommand(250, 0));
    assertThat(car.status()).isEqualTo(MotionFlag.MOVING);
  }

  @Test
  void stopOnCollisionFailsAndNeverArrives() {
    MotionAutomaton robot = automaton(CollisionPolicy.STOP_ON_COLLISION);
    after(0, robot, START, Bumps.NONE);
    assertThat(after(60, robot, START, Bumps.LEFT)).isEqualTo(WheelCommand.STOP);
    assertThat(robot.status()).isEqualTo(MotionFlag.FAIL);
    assertThat(robot.state()).isEqualTo(MotionState.FAILED);
    assertThat(after(60, robot, START, Bumps.NONE)).isEqualTo(WheelCommand.STOP);
    assertThat(robot.status()).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void aRobotThatExploresOrWandersBacksOffUnderEveryPolicy() {
    for (CollisionPolicy policy : CollisionPolicy.values()) {
      for (RobotType type : List.of(RobotType.DISCOVERY, RobotType.RANDOM_MOVER)) {
        MotionAutomaton robot = automaton(policy, type, 1);
        // A random mover wanders first.
        WheelCommand command = after(0, robot, START, Bumps.NONE);
        double rad = 0;
        for (int i = 0; i < 500 && !(command.linearMmPerS() > 0); i++) {
          rad += 0.06 * command.angularRadPerS();
          command = after(60, robot, new Pose(0, 0, rad), Bumps.NONE);
        }
        assertThat(after(60, robot, START, Bumps.BOTH).linearMmPerS())
            .as("%s %s", policy, type)
            .isNegative();
        assertThat(robot.status()).isEqualTo(MotionFlag.MOVING);
      }
    }
  }

  @Test
  void aRandomMoverTurnsAndDrivesAsideOnlyWithoutARegionToAvoid() {
    for (boolean mayWander : new boolean[] {true, false}) {
      MotionParameters parameters =
          MotionParameters.builder().robotType(RobotType.RANDOM_MOVER).build();
      MotionAutomaton robot = MotionAutomaton.goTo(AHEAD, mayWander, parameters, new Rng(3));
      WheelCommand turn = after(0, robot, START, Bumps.NONE);
      assertThat(turn.angularRadPerS()).isNotZero();
      assertThat(turn.linearMmPerS()).isZero();
      double rad = 0;
      for (int i = 0; i < 500 && robot.state() == MotionState.COLLISION_TURN; i++) {
        rad += 0.06 * after(60, robot, new Pose(0, 0, rad), Bumps.NONE).angularRadPerS();
      }
      assertThat(robot.state())
          .isEqualTo(mayWander ? MotionState.COLLISION_STRAIGHT : MotionState.TURN);
    }
  }

  @Test
  void aBumpAtTheTargetIsNotAnArrival() {
    MotionAutomaton robot = automaton(CollisionPolicy.STOP_ON_COLLISION);
    after(0, robot, START, Bumps.NONE);
    after(60, robot, new Pose(1999, 0, 0), Bumps.RIGHT);
    assertThat(robot.status()).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void aRobotThatTouchesAnObjectAtTheStartMayTurnButNotDrive() {
    MotionAutomaton robot = automaton(CollisionPolicy.STOP_ON_COLLISION);
    assertThat(after(0, robot, facing(90), Bumps.BOTH).linearMmPerS()).isZero();
    assertThat(robot.status()).isEqualTo(MotionFlag.MOVING);
    assertThat(after(60, robot, facing(45), Bumps.RIGHT).angularRadPerS()).isNegative();
    assertThat(after(60, robot, facing(0), Bumps.RIGHT)).isEqualTo(WheelCommand.STOP);
    assertThat(robot.status()).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void aBumpAfterAReleaseIsANewBump() {
    MotionAutomaton robot = automaton(CollisionPolicy.STOP_ON_COLLISION);
    after(0, robot, facing(90), Bumps.BOTH);
    after(60, robot, facing(60), Bumps.NONE);
    after(60, robot, facing(40), Bumps.LEFT);
    assertThat(robot.status()).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void avoidingTurnsAwayUntilClearDrivesStraightAndGoesOn() {
    MotionAutomaton robot = automaton(CollisionPolicy.USE_COLAVOID);
    after(0, robot, START, Bumps.NONE);
    assertThat(after(60, robot, START, Bumps.RIGHT).angularRadPerS()).isPositive();
    assertThat(robot.state()).isEqualTo(MotionState.COLLISION_TURN);
    assertThat(after(700, robot, facing(40), Bumps.RIGHT).angularRadPerS()).isPositive();
    WheelCommand away = after(60, robot, facing(50), Bumps.NONE);
    assertThat(robot.state()).isEqualTo(MotionState.COLLISION_STRAIGHT);
    assertThat(away.linearMmPerS()).isPositive();
    assertThat(away.angularRadPerS()).isZero();
    after(1240, robot, new Pose(150, 180, Angles.fromDegrees(50)), Bumps.NONE);
    assertThat(robot.state()).isEqualTo(MotionState.COLLISION_STRAIGHT);
    after(10, robot, new Pose(150, 180, Angles.fromDegrees(50)), Bumps.NONE);
    assertThat(robot.state()).isEqualTo(MotionState.TURN);
    assertThat(robot.status()).isEqualTo(MotionFlag.MOVING);
  }

  @Test
  void aBumpOnTheLeftIsAvoidedToTheRight() {
    MotionAutomaton robot = automaton(CollisionPolicy.USE_COLAVOID);
    after(0, robot, START, Bumps.NONE);
    assertThat(after(60, robot, START, Bumps.LEFT).angularRadPerS()).isNegative();
  }

  @Test
  void aGoalRobotBacksOffAndFails() {
    MotionAutomaton robot = automaton(CollisionPolicy.USE_COLBACK);
    after(0, robot, START, Bumps.NONE);
    assertThat(after(60, robot, START, Bumps.BOTH)).isEqualTo(new WheelCommand(-125, 0));
    assertThat(after(799, robot, START, Bumps.NONE)).isEqualTo(new WheelCommand(-125, 0));
    assertThat(after(1, robot, new Pose(-100, 0, 0), Bumps.NONE)).isEqualTo(WheelCommand.STOP);
    assertThat(robot.status()).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void aDiscoveryRobotBacksOffTurnsFollowsOnAnArcAndGoesOn() {
    MotionAutomaton robot = automaton(CollisionPolicy.USE_COLBACK, RobotType.DISCOVERY, 1);
    after(0, robot, START, Bumps.NONE);
    after(60, robot, START, Bumps.RIGHT);
    assertThat(after(800, robot, START, Bumps.NONE).angularRadPerS()).isPositive();
    WheelCommand arc = after(500, robot, facing(45), Bumps.NONE);
    assertThat(robot.state()).isEqualTo(MotionState.COLLISION_ARC);
    assertThat(arc.linearMmPerS() / arc.angularRadPerS()).isEqualTo(-320);
    after(500, robot, facing(-45), Bumps.NONE);
    assertThat(robot.state()).isEqualTo(MotionState.COLLISION_STRAIGHT);
    after(60, robot, facing(-45), Bumps.LEFT);
    assertThat(robot.state()).as("bumped anew").isEqualTo(MotionState.COLLISION_BACK);
  }

  @Test
  void aRandomMoverTurnsByARandomAngleOfAtMost90Degrees() {
    boolean left = false;
    boolean right = false;
    for (long seed = 0; seed < 20; seed++) {
      nowNs = 0;
      MotionAutomaton robot = automaton(CollisionPolicy.USE_COLBACK, RobotType.RANDOM_MOVER, seed);
      after(0, robot, START, Bumps.NONE);
      after(60, robot, START, Bumps.BOTH);
      double turn = after(800, robot, START, Bumps.NONE).angularRadPerS();
      left |= turn > 0;
      right |= turn < 0;
      Pose beyond = facing(turn > 0 ? 94 : -94);
      assertThat(after(60, robot, beyond, Bumps.NONE).angularRadPerS() * turn).isNotPositive();
    }
    assertThat(left && right).isTrue();
  }
}
