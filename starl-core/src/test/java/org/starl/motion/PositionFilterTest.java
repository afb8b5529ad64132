package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.starl.body.WheelCommand;
import org.starl.geometry.Angles;
import org.starl.geometry.Fix;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.random.Rng;

class PositionFilterTest {

  private static final long MS = 1_000_000;

  private final PositionFilter filter = new PositionFilter();

  private boolean fix(double x, double y, double errorMm, long atMs, long nowMs) {
    return filter.fixed(new Fix(new Pose(x, y, 0), atMs * MS, errorMm, 0), nowMs * MS);
  }

  private Location.Known at(long ms) {
    Location.Known known = filter.at(ms * MS);
    if (known == null) {
      throw new AssertionError("no fix");
    }
    return known;
  }

  private void drive(double linear, double angular, long atMs) {
    filter.commanded(new WheelCommand(linear, angular), false, atMs * MS);
  }

  @Test
  void nothingIsKnownBeforeTheFirstFix() {
    assertThat(filter.hasFix()).isFalse();
    assertThat(filter.at(5)).isNull();
  }

  @Test
  void aBodyAtRestStaysWhereItIsWithAnOldFix() {
    fix(10, 20, 5, 0, 0);
    assertThat(at(60_000).pose()).isEqualTo(new Pose(10, 20, 0));
    assertThat(at(60_000).errorMm()).isEqualTo(5);
    assertThat(at(60_000).fixAgeNs()).isEqualTo(60_000 * MS);
  }

  @Test
  void aMovingBodyIsExtrapolatedAndItsBoundGrowsByItsPath() {
    fix(0, 0, 5, 0, 0);
    drive(100, 0, 0);
    assertThat(at(300).pose()).isEqualTo(new Pose(30, 0, 0));
    assertThat(at(300).errorMm()).isCloseTo(35, within(1e-9));
  }

  @Test
  void aDelayedFixIsExtrapolatedWithTheCommandsSince() {
    fix(0, 0, 0, 0, 0);
    drive(100, 0, 0);
    drive(0, StrictMath.PI, 1000);
    drive(100, 0, 1500);
    // Measured at 500 ms, on the way along x, 3 mm off; heard of at 2000 ms.
    fix(50, 3, 0, 500, 2000);
    Pose now = at(2000).pose();
    assertThat(now.xMm()).isCloseTo(100, within(1e-9));
    assertThat(now.yMm()).isCloseTo(53, within(1e-9));
    assertThat(now.headingRad()).isCloseTo(StrictMath.PI / 2, within(1e-12));
  }

  @Test
  void twoFixesOfABodyAtRestAreBetterThanOne() {
    fix(0, 0, 10, 0, 0);
    fix(12, 0, 10, 75, 75);
    assertThat(at(75).pose().at().xMm()).isCloseTo(6, within(1e-9));
    assertThat(at(75).errorMm()).isCloseTo(8, within(1e-9));
  }

  @Test
  void whatIsAskedAgainAtOneTimeHasTheNewestFixAndAssumption() {
    fix(0, 0, 10, 0, 0);
    drive(100, 0, 0);
    assertThat(at(100).errorMm()).isCloseTo(20, within(1e-9));
    fix(10, 0, 5, 100, 100);
    assertThat(at(100).errorMm()).isCloseTo(5, within(1e-9));
    drive(0, 0, 100);
    assertThat(at(200).errorMm()).isCloseTo(5, within(1e-9));
    filter.assume(0, 50 * MS);
    assertThat(at(200).errorMm()).isGreaterThan(5);
  }

  @Test
  void aWorseFixInsideChangesNothing() {
    fix(0, 0, 1, 0, 0);
    fix(5, 0, 20, 75, 75);
    assertThat(at(75).pose()).isEqualTo(new Pose(0, 0, 0));
    assertThat(at(75).errorMm()).isEqualTo(1);
  }

  @Test
  void aJumpFasterThanTheSpeedIsCountedAndNotAccepted() {
    fix(0, 0, 5, 0, 0);
    drive(100, 0, 0);
    assertThat(fix(1000, 0, 5, 100, 100)).isFalse();
    assertThat(filter.contradictions()).isEqualTo(1);
    assertThat(at(100).pose().xMm()).isCloseTo(10, within(1e-9));
    assertThat(at(100).errorMm()).as("holds both").isCloseTo(995, within(1e-9));
    assertThat(at(100).fixAgeNs()).isEqualTo(100 * MS);
    // One outlier is forgotten with the next fix that fits.
    assertThat(fix(20, 0, 5, 200, 200)).isTrue();
    assertThat(at(200).errorMm()).isEqualTo(5);
  }

  @Test
  void aSecondFixThatConfirmsAJumpIsNotEnough() {
    fix(0, 0, 5, 0, 0);
    fix(1000, 0, 5, 100, 100);
    assertThat(fix(1001, 0, 5, 200, 200)).isFalse();
    assertThat(filter.contradictions()).isEqualTo(2);
    assertThat(at(200).pose().xMm()).isZero();
    assertThat(at(200).errorMm()).isBetween(1005.0, 1006.0);
    assertThat(at(200).fixAgeNs()).isEqualTo(200 * MS);
    assertThat(fix(3, 0, 5, 300, 300)).isTrue();
    assertThat(at(300).errorMm()).isLessThanOrEqualTo(5);
  }

  @Test
  void fixesThatAgreeLongEnoughAreAccepted() {
    fix(0, 0, 5, 0, 0);
    for (int ms = 100; ms < 30_100; ms += 100) {
      assertThat(fix(1000, 0, 5, ms, ms)).isFalse();
    }
    assertThat(fix(1000, 0, 5, 30_100, 30_100)).isTrue();
    assertThat(at(30_100).pose().xMm()).isEqualTo(1000);
    assertThat(at(30_100).errorMm()).isEqualTo(5);
    assertThat(filter.contradictions()).isEqualTo(301);
  }

  @Test
  void fixesThatContradictEachOtherAreNeverAccepted() {
    fix(0, 0, 5, 0, 0);
    for (int ms = 100; ms < 90_000; ms += 100) {
      assertThat(fix(1000 + ms % 400, 0, 5, ms, ms)).isFalse();
    }
    assertThat(at(90_000).pose().xMm()).isZero();
  }

  @Test
  void aContradictingHeadingIsCountedAndItsFixNotAccepted() {
    filter.fixed(new Fix(new Pose(0, 0, 0), 0, 5, 0.1), 0);
    Fix turned = new Fix(new Pose(3, 0, 1), 100 * MS, 5, 0.1);
    assertThat(filter.fixed(turned, 100 * MS)).isFalse();
    assertThat(filter.contradictions()).isEqualTo(1);
    assertThat(at(100).pose()).isEqualTo(new Pose(0, 0, 0));
    assertThat(at(100).errorRad()).as("holds both").isCloseTo(1.1, within(1e-9));
  }

  @Test
  void fixesOutOfOrderOrFromTheFutureAreNotUsed() {
    fix(0, 0, 5, 100, 100);
    assertThat(fix(1, 0, 5, 50, 120)).isFalse();
    assertThat(fix(1, 0, 5, 300, 200)).isFalse();
    assertThat(filter.outdated()).isEqualTo(2);
    assertThat(filter.contradictions()).isZero();
  }

  @Test
  void moreCommandsThanItStoresWidenTheBoundAndDoNotResetTheEstimate() {
    fix(0, 0, 5, 0, 0);
    for (int i = 0; i < 100; i++) {
      drive(i % 2, 0, 10L * i);
    }
    assertThat(at(1000).errorMm()).isCloseTo(5.5, within(1e-9));
    assertThat(fix(3000, 0, 5, 1000, 1000)).isFalse();
    assertThat(fix(7, 0, 5, 1010, 1010)).isTrue();
  }

  @Test
  void theBoundCoversAContradictingPlaceThatHasMovedByMoreCommandsThanItStores() {
    fix(0, 0, 5, 0, 0);
    drive(100, 0, 0);
    fix(1000, 0, 5, 10, 10);
    for (int i = 0; i < 100; i++) {
      drive(101 - i % 2, 0, 10L * i + 10);
    }
    double rivalMm = 1000 + 100.5;
    assertThat(at(1010).pose().distanceMm(new Point(rivalMm, 0)))
        .isLessThanOrEqualTo(at(1010).errorMm() - 5 - 100);
  }

  @Test
  void commandsThatMayStillBeInEffectAreNotForgotten() {
    filter.assume(0, 500 * MS);
    fix(0, 0, 0, 0, 0);
    drive(100, 0, 0);
    for (int i = 0; i < 100; i++) {
      filter.commanded(WheelCommand.STOP, i % 2 == 0, i * MS);
    }
    assertThat(at(1000).errorMm()).isCloseTo(50, within(1e-9));
  }

  @Test
  void aFirstFixOlderThanTheReactionToTheOldestStoredCommandIsOutdated() {
    filter.assume(0, 50 * MS);
    for (int i = 0; i < 100; i++) {
      drive(i % 2, 0, 10L * i);
    }
    // The oldest command that it remembers was given at 360 ms.
    assertThat(fix(0, 0, 5, 380, 990)).isFalse();
    assertThat(filter.outdated()).isEqualTo(1);
    assertThat(fix(0, 0, 5, 410, 990)).isTrue();
    assertThat(at(990).errorMm()).isFinite();
  }

  @Test
  void aBodyThatTouchesSomethingMaySlide() {
    fix(0, 0, 0, 0, 0);
    filter.commanded(new WheelCommand(100, 0), true, 0);
    assertThat(at(100).errorMm()).isCloseTo(20, within(1e-9));
    assertThat(at(100).errorRad()).as("it rolls along the object").isCloseTo(0.1, within(1e-9));
  }

  @Test
  void aCommandThatTakesEffectLateWidensTheBound() {
    filter.assume(0, 50 * MS);
    fix(0, 0, 0, 0, 0);
    drive(100, 0, 0);
    filter.commanded(WheelCommand.STOP, false, 100 * MS);
    assertThat(at(500).errorMm()).isCloseTo(10 + 5, within(1e-9));
  }

  @Test
  void aFixDuringTheReactionTimeKeepsTheAllowance() {
    filter.assume(0, 50 * MS);
    fix(0, 0, 0, 0, 0);
    drive(100, 0, 0);
    drive(0, 0, 100);
    fix(10, 0, 0, 120, 120);
    assertThat(at(120).errorMm()).isZero();
    // It may have gone on from 120 ms to 150 ms, whatever the fix in between said.
    assertThat(at(140).errorMm()).isCloseTo(2, within(1e-9));
    assertThat(at(500).errorMm()).isCloseTo(3, within(1e-9));
  }

  @Test
  void aLateStartCountsAsBlocked() {
    filter.assume(0, 50 * MS);
    fix(0, 0, 0, 0, 0);
    drive(100, 0, 0);
    assertThat(at(200).errorMm()).as("nothing beyond being held up").isCloseTo(20, within(1e-9));
  }

  @Test
  void tooFastWheelsWidenTheBoundSideways() {
    filter.assume(0.2, 0);
    filter.fixed(new Fix(new Pose(0, 0, 0), 0, 0, StrictMath.PI / 2), 0);
    drive(100, 0, 0);
    // At most 120 mm at a right angle to where 100 mm were expected.
    double mostMm = Math.sqrt(100 * 100 + 120 * 120);
    assertThat(at(1000).errorMm()).isCloseTo(mostMm, within(1e-9));
  }

  @Test
  void theWorstAssumedWheelsCount() {
    filter.assume(0, 50 * MS);
    filter.assume(0, 0);
    fix(0, 0, 0, 0, 0);
    drive(100, 0, 0);
    drive(0, 0, 100);
    assertThat(at(500).errorMm()).isCloseTo(10 + 5, within(1e-9));
  }

  @Test
  void aLateFixCountsWhatAForgottenCommandMayHaveCaused() {
    filter.assume(0, 120 * MS);
    fix(0, 0, 0, 0, 0);
    drive(200, 0, 0);
    drive(0, 0, 500);
    // So many commands that the first ones are forgotten.
    for (int i = 0; i < 63; i++) {
      drive(0, 0, 1000 + i);
    }
    filter.at(1062 * MS);
    // The path of 100 mm, and 120 ms more: the body may have stopped late.
    assertThat(fix(100, 100 + 24, 0, 700, 1062)).isTrue();
  }

  /** Driving and turning may fail each on its own: the body drives straight on, away from the arc. */
  @Test
  void aBodyThatDoesNotTurnIsWithinTheBound() {
    fix(0, 0, 0, 0, 0);
    drive(100, StrictMath.PI / 2, 0);
    Location.Known known = at(2_000);
    assertThat(known.pose().distanceMm(new Point(200, 0))).isBetween(200.0, known.errorMm());
  }

  @Property(tries = 500)
  void theTruePositionIsAlwaysWithinTheBound(@ForAll long seed) {
    Rng rng = new Rng(seed);
    double speedError = rng.nextBoolean(0.5) ? 0 : 0.5 * rng.nextDouble();
    long reactionMs = rng.nextBoolean(0.5) ? 0 : rng.nextLong(1, 150);
    PositionFilter any = new PositionFilter();
    any.assume(speedError, reactionMs * MS);
    Wheels wheels = new Wheels(speedError, reactionMs * MS, rng.fork("wheels"));
    Pose truth = new Pose(0, 0, rng.nextDouble());
    double noiseMm = 40 * rng.nextDouble();
    double noiseRad = (rng.nextBoolean(0.7) ? 0.2 : 3) * rng.nextDouble();
    double fixes = rng.nextBoolean(0.7) ? 0.5 : 0.02;
    long nowNs = 0;
    for (int i = 0; i < 300; i++) {
      long stepNs = rng.nextLong(0, 40 * MS);
      truth = wheels.drive(truth, nowNs, nowNs + stepNs);
      nowNs += stepNs;
      if (rng.nextBoolean(fixes)) {
        any.fixed(noisy(truth, noiseMm, noiseRad, nowNs, rng), nowNs);
      } else {
        WheelCommand command =
            rng.nextBoolean(0.2)
                ? WheelCommand.STOP
                : new WheelCommand(600 * rng.nextDouble() - 200, 6 * rng.nextDouble() - 3);
        any.commanded(command, false, nowNs);
        wheels.command(command, nowNs);
      }
      Location.Known known = any.at(nowNs);
      if (known != null) {
        assertThat(known.pose().distanceMm(truth.at())).isLessThanOrEqualTo(known.errorMm() + 1e-6);
        double offRad = Angles.difference(truth.headingRad(), known.pose().headingRad());
        assertThat(Math.abs(offRad)).isLessThanOrEqualTo(known.errorRad() + 1e-6);
      }
    }
    assertThat(any.contradictions()).isZero();
  }

  private static Fix noisy(Pose truth, double errorMm, double errorRad, long atNs, Rng rng) {
    double angle = 7 * rng.nextDouble();
    double radius = errorMm * rng.nextDouble();
    Pose measured =
        new Pose(
            truth.xMm() + radius * StrictMath.cos(angle),
            truth.yMm() + radius * StrictMath.sin(angle),
            truth.headingRad() + errorRad * (2 * rng.nextDouble() - 1));
    return new Fix(measured, atNs, errorMm, errorRad);
  }
}
