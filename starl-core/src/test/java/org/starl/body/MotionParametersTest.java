package org.starl.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
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

  private static final Set<String> MAY_BE_0 =
      Set.of(
          "slowFwdRadiusMm",
          "arcRadiusMm",
          "collisionStraightMs",
          "collisionBackMs",
          "collisionTurnMs",
          "speedError",
          "reactionMs",
          "avoidPatienceMs");

  /** The default parameters, with another number in one place. */
  private static MotionParameters with(RecordComponent changed, double number) {
    RecordComponent[] components = MotionParameters.class.getRecordComponents();
    Class<?>[] types = new Class<?>[components.length];
    Object[] values = new Object[components.length];
    try {
      for (int i = 0; i < components.length; i++) {
        types[i] = components[i].getType();
        values[i] = components[i].getAccessor().invoke(MotionParameters.DEFAULT);
        if (components[i].getName().equals(changed.getName())) {
          values[i] = types[i] == long.class ? (Object) (long) number : (Object) number;
        }
      }
      return MotionParameters.class.getDeclaredConstructor(types).newInstance(values);
    } catch (InvocationTargetException e) {
      throw (IllegalArgumentException) e.getCause();
    } catch (ReflectiveOperationException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void everyNumberHasALeastValueAndIsFinite() {
    int numbers = 0;
    for (RecordComponent each : MotionParameters.class.getRecordComponents()) {
      if (each.getType() != long.class && each.getType() != double.class) {
        continue;
      }
      numbers++;
      List<Double> refused = new ArrayList<>(List.of(-1.0));
      if (!MAY_BE_0.contains(each.getName())) {
        refused.add(0.0);
      }
      if (each.getType() == double.class) {
        refused.addAll(List.of(Double.NaN, Double.POSITIVE_INFINITY));
      }
      for (double value : refused) {
        assertThatThrownBy(() -> with(each, value))
            .as("%s %s", each.getName(), value)
            .isInstanceOf(IllegalArgumentException.class);
      }
      if (MAY_BE_0.contains(each.getName())) {
        assertThat(with(each, 0)).isNotNull();
      }
    }
    assertThat(numbers).isGreaterThan(25);
  }

  @Test
  void limitsAreExclusiveAndPairsMayBeEqual() {
    MotionParameters p = MotionParameters.DEFAULT;
    assertThatThrownBy(() -> p.toBuilder().speedError(1).build()).hasMessageContaining("below 1");
    assertThatThrownBy(() -> p.toBuilder().arcAngleMaxRad(StrictMath.PI / 2).build())
        .hasMessageContaining("arcAngleMaxRad");
    assertThatThrownBy(() -> p.toBuilder().arcExitAngleRad(StrictMath.PI / 2).build())
        .hasMessageContaining("arcExitAngleRad");
    assertThat(p.toBuilder().linSpeedMinMmPerS(p.linSpeedMaxMmPerS()).build()).isNotNull();
    assertThatThrownBy(() -> p.toBuilder().failFixAgeMs(p.maxFixAgeMs() - 1).build())
        .hasMessageContaining("fix ages");
    assertThatThrownBy(() -> p.toBuilder().slowTurnAngleRad(p.smallTurnAngleRad() / 2).build())
        .hasMessageContaining("turn angles");
    assertThatThrownBy(() -> p.toBuilder().arcAngleMaxRad(p.smallTurnAngleRad() / 2).build())
        .hasMessageContaining("smallTurnAngleRad and arcAngleMaxRad");
  }

  @Test
  void derivedLengthsAndTimes() {
    MotionParameters p = MotionParameters.builder().goalRadiusMm(90).slowestMmPerS(20).build();
    assertThat(p.cornerRadiusMm()).isEqualTo(30);
    assertThat(p.longestMs(1_010) - p.longestMs(0)).isEqualTo(50_500);
    assertThat(p.longestMs(0)).isEqualTo(p.failFixAgeMs() + p.noProgressMs());
    assertThat(p.toBuilder().speedError(0.5).build().reachS())
        .isCloseTo(1.5 * p.horizonS(), within(1e-9));
  }

  @Test
  void wheelsOnBothSidesOfACommand() {
    WheelCommand left = new WheelCommand(100, 0.5);
    assertThat(left.leftMmPerS(240)).isEqualTo(40);
    assertThat(left.rightMmPerS(240)).isEqualTo(160);
    assertThat(left.fastestMmPerS(240)).isEqualTo(160);
    WheelCommand right = new WheelCommand(-100, 0.5);
    assertThat(right.fastestMmPerS(240)).isEqualTo(160);
    assertThatThrownBy(() -> new WheelCommand(Double.NaN, 0)).hasMessageContaining("not finite");
    assertThatThrownBy(() -> new WheelCommand(0, Double.POSITIVE_INFINITY))
        .hasMessageContaining("not finite");
  }

  @Test
  void bothSensorsTogether() {
    assertThat(Bumps.of(false, false)).isEqualTo(Bumps.NONE);
    assertThat(Bumps.of(true, false)).isEqualTo(Bumps.LEFT);
    assertThat(Bumps.of(false, true)).isEqualTo(Bumps.RIGHT);
    assertThat(Bumps.of(true, true)).isEqualTo(Bumps.BOTH);
    assertThat(Bumps.NONE.any()).isFalse();
  }

  @Test
  void twoPoliciesEndAMotion() {
    assertThat(CollisionPolicy.values())
        .filteredOn(CollisionPolicy::fails)
        .containsExactly(CollisionPolicy.STOP_ON_COLLISION, CollisionPolicy.USE_COLBACK);
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
