package org.starl.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.starl.geometry.Angles;

class MotionParametersTest {

  @Test
  void theDefaultsAreTheOriginals() {
    MotionParameters p = MotionParameters.DEFAULT;
    assertThat(Angles.toDegrees(p.turnSpeedMaxRadPerS())).isCloseTo(110, within(1e-9));
    assertThat(Angles.toDegrees(p.turnSpeedMinRadPerS())).isCloseTo(25, within(1e-9));
    assertThat(p.linSpeedMaxMmPerS()).isEqualTo(250);
    assertThat(p.linSpeedMinMmPerS()).isEqualTo(175);
    assertThat(p.goalRadiusMm()).isEqualTo(75);
    assertThat(p.slowFwdRadiusMm()).isEqualTo(700);
    assertThat(Angles.toDegrees(p.smallTurnAngleRad())).isCloseTo(3, within(1e-9));
    assertThat(Angles.toDegrees(p.slowTurnAngleRad())).isCloseTo(25, within(1e-9));
    assertThat(Angles.toDegrees(p.straightAngleRad())).isCloseTo(6, within(1e-9));
    assertThat(Angles.toDegrees(p.arcExitAngleRad())).isCloseTo(30, within(1e-9));
    assertThat(Angles.toDegrees(p.arcAngleMaxRad())).isCloseTo(25, within(1e-9));
    assertThat(p.arcRadiusMm()).isEqualTo(700);
    assertThat(p.arcSpeedMaxMmPerS()).isEqualTo(200);
    assertThat(p.enableArcing()).isTrue();
    assertThat(p.stopAtDestination()).isTrue();
    assertThat(p.robotRadiusMm()).isEqualTo(165);
    assertThat(p.automatonPeriodMs()).isEqualTo(60);
    assertThat(p.collisionPolicy()).isEqualTo(CollisionPolicy.STOP_ON_COLLISION);
    assertThat(p.collisionStraightMs()).isEqualTo(1250);
    assertThat(p.collisionBackMs()).isEqualTo(800);
    assertThat(p.collisionTurnMs()).isEqualTo(500);
  }

  @Test
  void invalidParametersAreRefusedByName() {
    assertThatThrownBy(() -> MotionParameters.builder().goalRadiusMm(0).build())
        .hasMessage("goalRadiusMm 0.0: expected above 0");
    assertThatThrownBy(() -> MotionParameters.builder().linSpeedMinMmPerS(300).build())
        .hasMessageContaining("forward speeds");
    assertThatThrownBy(() -> MotionParameters.builder().automatonPeriodMs(-5).build())
        .hasMessageContaining("automatonPeriodMs -5");
    assertThatThrownBy(() -> MotionParameters.builder().linSpeedMaxMmPerS(Double.NaN).build())
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void parametersCanBeChangedOneByOne() {
    MotionParameters changed =
        MotionParameters.DEFAULT.toBuilder().goalRadiusMm(10).robotRadiusMm(100).build();
    assertThat(changed.goalRadiusMm()).isEqualTo(10);
    assertThat(changed.robotRadiusMm()).isEqualTo(100);
    assertThat(changed.toBuilder().goalRadiusMm(75).robotRadiusMm(165).build())
        .isEqualTo(MotionParameters.DEFAULT);
  }
}
