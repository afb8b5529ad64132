package org.starl.robot;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.starl.body.MotionParameters;
import org.starl.robot.file.Limits;

/** What a deployment says of its wheels, its robots' programs expect. */
class RealMotionTest {

  private static final MotionParameters USUAL = MotionParameters.DEFAULT;

  @Test
  void theProgramAllowsForTheLatencyAndErrorOfTheWheels() {
    MotionParameters real = RealMotion.of(USUAL, new Limits(500, 300, 500, 0.1, 200));

    assertThat(real)
        .isEqualTo(USUAL.toBuilder().speedError(0.1).reactionMs(200).build())
        .isNotEqualTo(USUAL);
  }

  @Test
  void largerAllowancesOfAnAppAreKept() {
    MotionParameters careful = USUAL.toBuilder().speedError(0.3).reactionMs(400).build();

    assertThat(RealMotion.of(careful, new Limits(500, 300, 500, 0.1, 200))).isEqualTo(careful);
  }

  @Test
  void speedsAreLimited() {
    MotionParameters real = RealMotion.of(USUAL, new Limits(10, 300, 500, 0, 0));

    assertThat(real.linSpeedMaxMmPerS()).isEqualTo(10);
    assertThat(real.linSpeedMinMmPerS()).isEqualTo(10);
    assertThat(real.arcSpeedMaxMmPerS()).isEqualTo(10);
  }
}
