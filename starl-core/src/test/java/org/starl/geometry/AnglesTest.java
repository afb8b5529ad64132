package org.starl.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class AnglesTest {

  @Test
  void oppositeDirectionsAreAtPlusPi() {
    assertThat(Angles.normalize(StrictMath.PI)).isEqualTo(StrictMath.PI);
    assertThat(Angles.normalize(-StrictMath.PI)).isEqualTo(StrictMath.PI);
    assertThat(Angles.difference(StrictMath.PI / 2, -StrictMath.PI / 2)).isEqualTo(StrictMath.PI);
  }

  @Test
  void degreesConvertBothWays() {
    assertThat(Angles.fromDegrees(180)).isEqualTo(StrictMath.PI);
    assertThat(Angles.toDegrees(Angles.fromDegrees(25))).isCloseTo(25, within(1e-12));
  }

  @Property
  void normalizingKeepsTheDirection(@ForAll @DoubleRange(min = -1e4, max = 1e4) double angle) {
    double normal = Angles.normalize(angle);
    assertThat(normal).isGreaterThan(-StrictMath.PI).isLessThanOrEqualTo(StrictMath.PI);
    assertThat(StrictMath.cos(normal)).isCloseTo(StrictMath.cos(angle), within(1e-9));
    assertThat(StrictMath.sin(normal)).isCloseTo(StrictMath.sin(angle), within(1e-9));
  }

  @Property
  void normalizingIsTheRemainderToTheLastBit(
      @ForAll @DoubleRange(min = -20, max = 20) double angle,
      @ForAll @IntRange(min = -9, max = 9) int quarters,
      @ForAll @IntRange(min = -3, max = 3) int steps) {
    double edge = quarters * (StrictMath.PI / 2);
    for (int i = 0; i < Math.abs(steps); i++) {
      edge = steps > 0 ? Math.nextUp(edge) : Math.nextDown(edge);
    }
    for (double one : new double[] {angle, edge, -edge}) {
      double rest = StrictMath.IEEEremainder(one, 2 * StrictMath.PI);
      double expected = rest <= -StrictMath.PI ? StrictMath.PI : rest;
      assertThat(Double.doubleToRawLongBits(Angles.normalize(one)))
          .as("%s", one)
          .isEqualTo(Double.doubleToRawLongBits(expected));
    }
  }

  @Property
  void theDifferenceLeadsFromOneDirectionToTheOther(
      @ForAll @DoubleRange(min = -10, max = 10) double from,
      @ForAll @DoubleRange(min = -10, max = 10) double to) {
    double turned = Angles.normalize(from + Angles.difference(to, from));
    assertThat(StrictMath.cos(turned - to)).isCloseTo(1, within(1e-12));
  }
}
