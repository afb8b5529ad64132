package org.starl.motion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.body.WheelCommand;
import org.starl.random.Rng;

class OdometryTest {

  private static final long REACTION_NS = 120_000_000;

  @Test
  void commandsThatAreOverDoNotMatterForLaterMotions() {
    for (int seed = 0; seed < 300; seed++) {
      Rng rng = new Rng(seed);
      Odometry all = new Odometry();
      Odometry few = new Odometry();
      long reactionNs = rng.nextBoolean(0.5) ? REACTION_NS : 0;
      all.assume(0.1, reactionNs);
      few.assume(0.1, reactionNs);
      long nowNs = 0;
      long fixNs = 0;
      for (int i = 0; i < 60; i++) {
        nowNs += rng.nextLong(0, 80_000_000);
        if (rng.nextBoolean(0.4)) {
          fixNs = rng.nextLong(fixNs, nowNs);
          few.forgetBefore(fixNs);
        }
        WheelCommand command =
            new WheelCommand(300 * rng.nextDouble() - 100, rng.nextBoolean(0.5) ? 0 : 1);
        boolean isBumped = rng.nextBoolean(0.2);
        all.commanded(command, isBumped, nowNs);
        few.commanded(command, isBumped, nowNs);
        for (int j = 0; j < 3; j++) {
          long beginNs = rng.nextLong(fixNs, nowNs);
          long endNs = rng.nextLong(beginNs, nowNs + 50_000_000);
          assertThat(located(few, beginNs, endNs)).isEqualTo(located(all, beginNs, endNs));
        }
        assertThat(few.lingering(nowNs)).isEqualTo(all.lingering(nowNs));
      }
    }
  }

  @Test
  void everyCommandThatMayStillBeInEffectLingers() {
    Odometry odometry = new Odometry();
    odometry.assume(0, REACTION_NS);
    odometry.commanded(new WheelCommand(250, -2), false, 1_000_000_000);
    odometry.commanded(new WheelCommand(100, 0), false, 1_050_000_000);
    odometry.commanded(new WheelCommand(25, 0), false, 1_100_000_000);
    assertThat(odometry.lingering(1_050_000_000 + REACTION_NS - 1))
        .as("two later ones, and each takes effect late")
        .isEqualTo(new LingeringSpeeds(0, 250, -2, 0));
    assertThat(odometry.lingering(1_050_000_000 + REACTION_NS))
        .as("the second one is in effect")
        .isEqualTo(new LingeringSpeeds(0, 100, 0, 0));
  }

  @Test
  void aWorseAssumptionCountsForAMotionThatWasLocatedBefore() {
    Odometry odometry = new Odometry();
    odometry.commanded(new WheelCommand(200, 0), false, 0);
    odometry.commanded(WheelCommand.STOP, false, 1_000_000_000);
    odometry.locate(500_000_000, 2_000_000_000);
    double before = odometry.strayMm();
    odometry.assume(0, REACTION_NS);
    odometry.locate(500_000_000, 2_000_000_000);
    assertThat(before).isZero();
    assertThat(odometry.strayMm()).isEqualTo(200 * 0.12);
  }

  /** Another motion may still be under way, or its commands in effect. */
  @Test
  void noPartOfAnAssumptionGetsBetter() {
    Odometry odometry = new Odometry();
    odometry.assume(0.1, REACTION_NS);
    odometry.assume(0.2, REACTION_NS / 2);
    odometry.commanded(new WheelCommand(200, 0), false, 0);
    odometry.commanded(WheelCommand.STOP, false, 1_000_000_000);
    assertThat(odometry.speedError()).isEqualTo(0.2);
    assertThat(odometry.lingering(1_000_000_000 + REACTION_NS - 1).mostMmPerS()).isEqualTo(200);

    Odometry other = new Odometry();
    other.assume(0.2, REACTION_NS / 2);
    other.assume(0.1, REACTION_NS);
    assertThat(other.speedError()).isEqualTo(0.2);
  }

  private static double[] located(Odometry odometry, long beginNs, long endNs) {
    odometry.locate(beginNs, endNs);
    return new double[] {
      odometry.forwardMm(),
      odometry.leftMm(),
      odometry.turnRad(),
      odometry.pathMm(),
      odometry.strayMm(),
      odometry.turnedRad()
    };
  }
}
