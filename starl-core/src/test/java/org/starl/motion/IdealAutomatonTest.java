package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.MotionStyle;
import org.starl.body.WheelCommand;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

class IdealAutomatonTest {

  private static final MotionParameters IDEAL =
      MotionParameters.builder().style(MotionStyle.IDEAL).build();

  @Property
  void itTurnsInOnePeriodDrivesAtFullSpeedAndStopsExactly(
      @ForAll @DoubleRange(min = -2000, max = 2000) double x,
      @ForAll @DoubleRange(min = -2000, max = 2000) double y,
      @ForAll @DoubleRange(min = -3, max = 3) double heading) {
    Point target = new Point(x, y);
    MotionWorld world = new MotionWorld(1, IDEAL, new Pose(100, 200, heading));
    double distanceMm = target.distanceMm(new Point(100, 200));
    assertThat(world.goTo(target, new Nowhere(), 60_000)).isEqualTo(MotionFlag.DONE);
    assertThat(world.truth.distanceMm(target)).isLessThan(1e-6);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    double bestS = 0.06 + distanceMm / 250;
    assertThat(world.seconds()).isBetween(0.0, bestS + 0.06 + 1e-9);
  }

  @Test
  void aBumpIsNotAnArrival() {
    MotionAutomaton robot = MotionAutomaton.goTo(new Point(500, 0), true, IDEAL, new Rng(1));
    robot.step(new Pose(0, 0, 0), Bumps.NONE, 0);
    assertThat(robot.step(new Pose(15, 0, 0), Bumps.LEFT, 60_000_000).isStop()).isTrue();
    assertThat(robot.status()).isEqualTo(MotionFlag.FAIL);
  }

  @Test
  void turnToFacesTheTargetAfterOnePeriod() {
    MotionAutomaton robot = MotionAutomaton.turnTo(new Point(0, 500), IDEAL, new Rng(1));
    WheelCommand turn = robot.step(new Pose(0, 0, 0), Bumps.NONE, 0);
    assertThat(turn.angularRadPerS() * 0.06).isCloseTo(StrictMath.PI / 2, within(1e-12));
    robot.step(new Pose(0, 0, StrictMath.PI / 2), Bumps.NONE, 60_000_000);
    assertThat(robot.status()).isEqualTo(MotionFlag.DONE);
  }
}
