package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.body.Bumps;
import org.starl.body.MotionParameters;
import org.starl.body.WheelCommand;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;

/** Motion control, safety (paper, section 4.1): the body is always outside the region to avoid. */
class AvoidGuardTest {

  private static final double RADIUS_MM = 165;

  @Test
  void aTargetInTheRegionFailsAtOnce() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region region = new Circle(new Point(1000, 0), 100);
    assertThat(world.goTo(new Point(800, 0), region, 0)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.TARGET_FORBIDDEN);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
  }

  @Test
  void aRegionInTheWayStopsTheRobotAndFails() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region region = new Circle(new Point(1000, 0), 100);
    assertThat(world.goTo(new Point(2000, 0), region, 20_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).isEqualTo(MotionFailure.IN_THE_WAY);
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    assertThat(world.nearestToAvoidMm).isBetween(RADIUS_MM, RADIUS_MM + 20);
  }

  @Test
  void aRegionBesideTheWayDoesNotStop() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region beside =
        Union.of(new Rectangle(-500, 190, 3000, 500), new Rectangle(-500, -500, 3000, -190));
    assertThat(world.goTo(new Point(2000, 0), beside, 20_000)).isEqualTo(MotionFlag.DONE);
  }

  @Test
  void aRobotInTheRegionMayTurnButNotDrive() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 3));
    Region here = new Circle(new Point(0, 0), 100);
    assertThat(world.goTo(new Point(2000, 0), here, 20_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.truth.at()).isEqualTo(new Point(0, 0));
  }

  // The wheels of the following: a period of 60 ms, a reaction of 100 ms.
  private static final MotionParameters LATE = MotionParameters.builder().reactionMs(100).build();

  /** How far the half-plane y <= 0 has to be for the guard to let this command through whole. */
  private static double nearestMm(
      MotionParameters p,
      WheelCommand command,
      double headingRad,
      Bumps bumps,
      LingeringSpeeds late) {
    return nearestMm(p, command, headingRad, 0, 0, bumps, late);
  }

  private static double nearestMm(
      MotionParameters p,
      WheelCommand command,
      double headingRad,
      double errorMm,
      double errorRad,
      Bumps bumps,
      LingeringSpeeds late) {
    AvoidGuard guard = new AvoidGuard(new Rectangle(-1e4, -1e4, 1e4, 0), p);
    double gapMm = RADIUS_MM;
    while (true) {
      Location.Known at =
          new Location.Known(new Pose(0, gapMm, headingRad), errorMm, errorRad, 0, 0);
      if (guard.limit(command, at, bumps, late).equals(command)) {
        return gapMm;
      }
      gapMm += 0.1;
    }
  }

  @Test
  void theLingeringEffectOfTheLastCommandIsAllowedFor() {
    LingeringSpeeds fast = LingeringSpeeds.NONE.with(250, 0);
    double down = -StrictMath.PI / 2;
    // 100 ms of the old command, 60 ms of the new one.
    assertThat(nearestMm(LATE, new WheelCommand(25, 0), down, Bumps.NONE, fast))
        .isGreaterThan(RADIUS_MM + 25 + 1.5);
    assertThat(nearestMm(LATE, new WheelCommand(25, 0), down, Bumps.NONE, LingeringSpeeds.NONE))
        .isLessThan(RADIUS_MM + 10);
  }

  @Test
  void aLingeringTurnIsAllowedFor() {
    LingeringSpeeds turning = LingeringSpeeds.NONE.with(0, -2);
    // It turns by 0.2 and then drives for 60 ms.
    assertThat(
            nearestMm(LATE, new WheelCommand(250, 0), -0.5, Bumps.NONE, turning)
                - nearestMm(LATE, new WheelCommand(250, 0), -0.5, Bumps.NONE, LingeringSpeeds.NONE))
        .isGreaterThan(15 * 0.2);
  }

  @Test
  void aBlockedTurnIsAllowedFor() {
    // Straight on, it comes 19 mm nearer; along the arc it never would, by more than 6 mm.
    assertThat(nearestMm(LATE, new WheelCommand(250, 6), -0.5, Bumps.NONE, LingeringSpeeds.NONE))
        .isGreaterThan(RADIUS_MM + 25 + 40 * StrictMath.sin(0.5));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 20, 60, 499})
  void aPositionErrorIsAllowedForHoweverLargeItIs(double errorMm) {
    WheelCommand down = new WheelCommand(25, 0);
    double rad = -StrictMath.PI / 2;
    assertThat(
            nearestMm(LATE, down, rad, errorMm, 0, Bumps.NONE, LingeringSpeeds.NONE)
                - nearestMm(LATE, down, rad, Bumps.NONE, LingeringSpeeds.NONE))
        .isBetween(errorMm - 0.2, errorMm + 0.2);
  }

  @Test
  void aHeadingErrorIsAllowedFor() {
    MotionParameters p = MotionParameters.DEFAULT;
    WheelCommand along = new WheelCommand(250, 0);
    assertThat(nearestMm(p, along, 0, 0, 0.5, Bumps.NONE, LingeringSpeeds.NONE))
        .isGreaterThan(RADIUS_MM + 15 * StrictMath.sin(0.5));
    assertThat(nearestMm(p, along, 0, 0, 0, Bumps.NONE, LingeringSpeeds.NONE))
        .isLessThan(RADIUS_MM + 3);
  }

  @Test
  void tooFastWheelsAreAllowedFor() {
    MotionParameters fast = MotionParameters.builder().speedError(0.5).build();
    double down = -StrictMath.PI / 2;
    assertThat(nearestMm(fast, new WheelCommand(250, 0), down, Bumps.NONE, LingeringSpeeds.NONE))
        .isGreaterThan(RADIUS_MM + 1.5 * 15);
  }

  @Test
  void slidingAlongATouchedObjectIsAllowedFor() {
    double along = 0;
    double needed = RADIUS_MM + 15;
    MotionParameters p = MotionParameters.DEFAULT;
    assertThat(nearestMm(p, new WheelCommand(250, 0), along, Bumps.BOTH, LingeringSpeeds.NONE))
        .isGreaterThan(needed);
    assertThat(nearestMm(p, new WheelCommand(250, 0), along, Bumps.NONE, LingeringSpeeds.NONE))
        .isLessThan(needed);
    assertThat(nearestMm(LATE, new WheelCommand(250, 0), along, Bumps.NONE, LingeringSpeeds.NONE))
        .as("from a bump until the stop that it brings")
        .isGreaterThan(RADIUS_MM + 25);
  }
}
