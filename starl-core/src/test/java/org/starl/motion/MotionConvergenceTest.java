package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.starl.body.MotionParameters;
import org.starl.body.MotionStyle;
import org.starl.body.WheelCommand;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

/** Without obstacles every motion ends DONE in time, near its target in truth. */
class MotionConvergenceTest {

  /** Room, noise of the fixes, and the parameters that an app may choose. */
  record Case(
      long seed,
      MotionStyle style,
      double goalRadiusMm,
      double noiseMm,
      double noiseRad,
      long delayMs) {}

  @Provide
  Arbitrary<Case> cases() {
    return Combinators.combine(
            Arbitraries.longs(),
            Arbitraries.of(MotionStyle.class),
            Arbitraries.of(10.0, 30.0, 75.0),
            Arbitraries.of(0.0, 5.0, 20.0, 50.0),
            Arbitraries.of(0.0, 0.01, 0.05),
            Arbitraries.of(0L, 30L, 100L))
        .as(Case::new);
  }

  @Property(tries = 2000)
  void everyMotionEndsNearItsTarget(@ForAll("cases") Case given) {
    Rng rng = new Rng(given.seed).fork("case");
    MotionParameters parameters =
        MotionParameters.builder().style(given.style).goalRadiusMm(given.goalRadiusMm).build();
    Point target = point(rng);
    MotionWorld world =
        new MotionWorld(
            given.seed, parameters, Pose.of(point(rng), 2 * StrictMath.PI * rng.nextDouble()));
    world.noiseMm = given.noiseMm;
    world.noiseRad = given.noiseRad;
    world.fixDelayMs = given.delayMs;
    double distanceMm = world.truth.distanceMm(target);
    assertThat(world.goTo(target, new Nowhere(), 60_000))
        .as(() -> String.valueOf(world.run().failure()))
        .isEqualTo(MotionFlag.DONE);
    assertThat(world.truth.distanceMm(target))
        .isLessThanOrEqualTo(given.goalRadiusMm + world.errorBoundMm + 1e-6);
    if (given.noiseRad == 0) {
      // Only a heading that is off leads the position astray between two fixes here.
      assertThat(world.truth.distanceMm(target))
          .isLessThanOrEqualTo(given.goalRadiusMm + given.noiseMm + 1e-6);
    }
    assertThat(world.command).isEqualTo(WheelCommand.STOP);
    // At the lowest speeds, and what noise costs near the target.
    assertThat(world.seconds()).isLessThan(4 + distanceMm / 175 + 0.2 * given.noiseMm);
    assertThat(world.worstErrorPastBoundMm).isLessThan(1e-6);
  }

  private static Point point(Rng rng) {
    return new Point(3000 * rng.nextDouble(), 3000 * rng.nextDouble());
  }
}
