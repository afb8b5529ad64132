package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.Point;
import org.starl.geometry.Polygon;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.geometry.Region;
import org.starl.geometry.Union;
import org.starl.random.Rng;

/** Motion control, safety (paper, section 4.1): the body is always outside the region to avoid. */
class AvoidGuardTest {

  private static final double RADIUS_MM = 165;

  record Case(
      long seed,
      MotionStyle style,
      CollisionPolicy policy,
      double noiseMm,
      double noiseRad,
      long delayMs,
      double mobility) {}

  @Provide
  Arbitrary<Case> cases() {
    return Combinators.combine(
            Arbitraries.longs(),
            Arbitraries.of(MotionStyle.class),
            Arbitraries.of(CollisionPolicy.class),
            Arbitraries.of(0.0, 10.0, 50.0),
            Arbitraries.of(0.0, 0.05, 0.5),
            Arbitraries.of(0L, 40L, 100L),
            Arbitraries.of(1.0, 0.8, 0.3))
        .as(Case::new);
  }

  @Property(tries = 2000)
  void theTrueBodyNeverEntersTheRegion(@ForAll("cases") Case given) {
    Rng rng = new Rng(given.seed).fork("case");
    MotionParameters parameters =
        MotionParameters.builder()
            .style(given.style)
            .collisionPolicy(given.policy)
            .robotType(RobotType.RANDOM_MOVER)
            .build();
    Region region = region(rng);
    MotionWorld world =
        new MotionWorld(
            given.seed, parameters, Pose.of(point(rng), 2 * StrictMath.PI * rng.nextDouble()));
    Assume.that(region.distanceMm(world.truth.at()) > RADIUS_MM);
    world.noiseMm = given.noiseMm;
    world.noiseRad = given.noiseRad;
    world.fixDelayMs = given.delayMs;
    world.mobility = given.mobility;
    world.wallMm = 1000 + 1000 * rng.nextDouble();
    world.bumpSensorsWork = rng.nextBoolean(0.7);
    Assume.that(world.truth.xMm() + RADIUS_MM < world.wallMm);
    world.goTo(point(rng), region, 30_000);
    assertThat(world.nearestToAvoidMm).isGreaterThan(RADIUS_MM);
    assertThat(world.worstErrorPastBoundMm).isLessThan(1e-6);
  }

  @Test
  void aTargetInTheRegionFailsAtOnce() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region region = new Circle(new Point(1000, 0), 100);
    assertThat(world.goTo(new Point(800, 0), region, 0)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).contains("target is in the region");
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
  }

  @Test
  void aRegionInTheWayStopsShortAndFails() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 0));
    Region region = new Circle(new Point(1000, 0), 100);
    assertThat(world.goTo(new Point(2000, 0), region, 20_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.run().failure()).contains("in the way");
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
  void whoStandsInTheRegionMayTurnButNotDrive() {
    MotionWorld world = new MotionWorld(1, MotionParameters.DEFAULT, new Pose(0, 0, 3));
    Region here = new Circle(new Point(0, 0), 100);
    assertThat(world.goTo(new Point(2000, 0), here, 20_000)).isEqualTo(MotionFlag.FAIL);
    assertThat(world.truth.at()).isEqualTo(new Point(0, 0));
  }

  private static Region region(Rng rng) {
    Point at = point(rng);
    double size = 50 + 500 * rng.nextDouble();
    return switch (rng.nextInt(3)) {
      case 0 -> new Circle(at, size);
      case 1 -> Rectangle.around(at, size, 2 * size);
      default ->
          Polygon.of(
              at,
              at.plus(new Point(size, size / 8)),
              at.plus(new Point(size / 3, size / 3)),
              at.plus(new Point(size / 8, size)));
    };
  }

  private static Point point(Rng rng) {
    return new Point(2000 * rng.nextDouble(), 2000 * rng.nextDouble());
  }
}
