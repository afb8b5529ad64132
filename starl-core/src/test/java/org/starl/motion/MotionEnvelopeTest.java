package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.Consumer;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.body.CollisionPolicy;
import org.starl.body.MotionParameters;
import org.starl.body.MotionStyle;
import org.starl.body.RobotType;
import org.starl.body.WheelCommand;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.random.Rng;

/**
 * Motion control under everything in its envelope (paper, section 4.1): the body is always outside
 * the region to avoid, DONE means near the target in truth, and every motion ends. Each of its
 * allowances is shown to be needed.
 */
class MotionEnvelopeTest {

  private static final double RADIUS_MM = 165;

  /** One drive drawn by seed: the errors of the world, and the bounds that the robot is given. */
  private static final class Drive {
    final Rng rng;
    final MotionParameters.Builder told = MotionParameters.builder();
    final Region region;
    final Point target;
    final Pose start;
    final double noiseMm;
    final double noiseRad;
    final double speedError;
    final long reactionMs;
    final long stepLateMs;
    double honesty = 1;

    Drive(long seed) {
      rng = new Rng(seed).fork("drive");
      region = region();
      target = point();
      start = Pose.of(point(), 2 * StrictMath.PI * rng.nextDouble());
      noiseMm = either(0, 60 * rng.nextDouble());
      noiseRad = either(0, 0.5 * rng.nextDouble());
      speedError = either(0, 0.5 * rng.nextDouble());
      reactionMs = (long) either(0, 150 * rng.nextDouble());
      stepLateMs = (long) either(0, 100 * rng.nextDouble());
      told.style(MotionStyle.values()[rng.nextInt(2)])
          .collisionPolicy(CollisionPolicy.values()[rng.nextInt(4)])
          .robotType(RobotType.values()[rng.nextInt(3)])
          .robotRadiusMm(RADIUS_MM)
          .speedError(speedError)
          .reactionMs(reactionMs + stepLateMs)
          .automatonPeriodMs(rng.nextLong(20, 150))
          .stopAtDestination(rng.nextBoolean(0.9));
    }

    MotionWorld world() {
      MotionWorld world = new MotionWorld(rng.nextLong(), told.build(), start);
      world.noiseMm = noiseMm;
      world.noiseRad = noiseRad;
      world.honesty = honesty;
      world.speedError = speedError;
      world.reactionMs = reactionMs;
      world.stepLateMs = stepLateMs;
      world.heldUp = either(0, rng.nextDouble());
      world.mobility = rng.nextBoolean(0.8) ? 1 : rng.nextDouble() * rng.nextInt(2);
      world.fixPeriodMs = rng.nextLong(20, 250);
      world.fixDelayMs = (long) either(0, 100 * rng.nextDouble());
      world.dropouts = either(0, 0.7 * rng.nextDouble());
      world.jumps = either(0, 0.3 * rng.nextDouble());
      world.wallMm = either(Double.POSITIVE_INFINITY, 1000 + 1500 * rng.nextDouble());
      world.bumpSensorsWork = rng.nextBoolean(0.7);
      return world;
    }

    boolean isPossible() {
      return region.distanceMm(start.at()) > RADIUS_MM;
    }

    private double either(double one, double other) {
      return rng.nextBoolean(0.4) ? one : other;
    }

    private Region region() {
      Point at = point();
      double size = 50 + 500 * rng.nextDouble();
      return switch (rng.nextInt(4)) {
        case 0 -> new Circle(at, size);
        case 1 -> Rectangle.around(at, size, 2 * size);
        case 2 -> Union.of(new Circle(at, size), Rectangle.around(point(), size, size));
        default ->
            Polygon.of(
                at,
                at.plus(new Point(size, size / 8)),
                at.plus(new Point(size / 3, size / 3)),
                at.plus(new Point(size / 8, size)));
      };
    }

    private Point point() {
      return new Point(2000 * rng.nextDouble(), 2000 * rng.nextDouble());
    }
  }

  @Property(tries = 4000)
  void theContractHoldsUnderEverythingInTheEnvelope(@ForAll long seed) {
    Drive drive = new Drive(seed);
    MotionWorld world = drive.world();
    if (!drive.isPossible() || world.truth.xMm() + RADIUS_MM >= world.wallMm) {
      return;
    }
    double distanceMm = world.truth.distanceMm(drive.target);
    MotionParameters told = world.parameters;
    long longestMs =
        told.longestMs(distanceMm + drive.noiseMm) + 2 * told.automatonPeriodMs() + 200;
    MotionFlag end = world.goTo(drive.target, drive.region, longestMs);
    assertThat(end).as("it ends").isIn(MotionFlag.DONE, MotionFlag.FAIL);
    if (end == MotionFlag.DONE) {
      assertThat(world.truth.distanceMm(drive.target))
          .isLessThanOrEqualTo(told.goalRadiusMm() + world.errorBoundMm + 1e-6);
    } else {
      assertThat(world.run().failure()).isNotNull();
      assertThat(world.command).isEqualTo(WheelCommand.STOP);
    }
    // Late commands may still take effect, or the robot may drive on through the target.
    world.idle(1_000);
    assertThat(world.nearestToAvoidMm).isGreaterThan(RADIUS_MM);
    assertThat(world.worstErrorPastBoundMm).isLessThan(1e-6);
  }

  @Test
  void theContractHoldsWhileABumpSensorClosesAndOpensManyTimesBetweenTwoFixes() {
    theContractHoldsUnderEverythingInTheEnvelope(-11218);
  }

  static Stream<Arguments> understatements() {
    return Stream.of(
        understated("the radius", drive -> drive.told.robotRadiusMm(RADIUS_MM - 5)),
        understated("the wheels' speed error", drive -> drive.told.speedError(0)),
        understated("the wheels' reaction", drive -> drive.told.reactionMs(drive.stepLateMs)),
        understated("late steps", drive -> drive.told.reactionMs(drive.reactionMs)),
        understated("the fixes' errors", drive -> drive.honesty = 0.5));
  }

  private static Arguments understated(String what, Consumer<Drive> how) {
    return Arguments.of(Named.of(what, how));
  }

  /** A robot with too small a bound enters the region, on some drive. */
  @ParameterizedTest
  @MethodSource("understatements")
  void eachAllowanceIsNeeded(Consumer<Drive> understate) {
    int entered = 0;
    for (long seed = 0; seed < 4_000 && entered == 0; seed++) {
      Drive drive = new Drive(seed);
      understate.accept(drive);
      if (drive.isPossible()) {
        MotionWorld world = drive.world();
        world.wallMm = Double.POSITIVE_INFINITY;
        world.goTo(drive.target, drive.region, 30_000);
        world.idle(500);
        entered += world.nearestToAvoidMm <= RADIUS_MM ? 1 : 0;
      }
    }
    assertThat(entered).isPositive();
  }
}
