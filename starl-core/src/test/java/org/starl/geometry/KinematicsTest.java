package org.starl.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;

class KinematicsTest {

  private static final Pose START = new Pose(100, -50, 0.7);

  @Test
  void aQuarterTurnEndsOneRadiusToTheSide() {
    Pose end = Kinematics.after(new Pose(0, 0, 0), 100, StrictMath.PI / 2, 1);
    double radius = 100 / (StrictMath.PI / 2);
    assertThat(end.xMm()).isCloseTo(radius, within(1e-9));
    assertThat(end.yMm()).isCloseTo(radius, within(1e-9));
    assertThat(end.headingRad()).isCloseTo(StrictMath.PI / 2, within(1e-12));
  }

  @Test
  void turningOnTheSpotStaysOnTheSpot() {
    Pose end = Kinematics.after(START, 0, 3, 5);
    assertThat(end.at()).isEqualTo(START.at());
    assertThat(end.headingRad()).isEqualTo(Angles.normalize(0.7 + 15));
  }

  @Property
  void theClosedFormIsTheLimitOfSmallSteps(
      @ForAll @DoubleRange(min = -500, max = 500) double linear,
      @ForAll @DoubleRange(min = -4, max = 4) double angular,
      @ForAll @DoubleRange(min = 0, max = 3) double seconds) {
    int steps = 4000;
    double x = START.xMm();
    double y = START.yMm();
    double stepS = seconds / steps;
    for (int i = 0; i < steps; i++) {
      double midway = START.headingRad() + angular * (i + 0.5) * stepS;
      x += linear * stepS * StrictMath.cos(midway);
      y += linear * stepS * StrictMath.sin(midway);
    }
    Pose end = Kinematics.after(START, linear, angular, seconds);
    assertThat(end.xMm()).isCloseTo(x, within(0.01));
    assertThat(end.yMm()).isCloseTo(y, within(0.01));
  }

  @Property
  void twoPartsOfAnArcMakeTheWhole(
      @ForAll @DoubleRange(min = -500, max = 500) double linear,
      @ForAll @DoubleRange(min = -4, max = 4) double angular,
      @ForAll @DoubleRange(min = -2, max = 2) double first,
      @ForAll @DoubleRange(min = -2, max = 2) double second) {
    Pose whole = Kinematics.after(START, linear, angular, first + second);
    Pose parts =
        Kinematics.after(Kinematics.after(START, linear, angular, first), linear, angular, second);
    assertThat(parts.distanceMm(whole.at())).isLessThan(1e-8);
    assertThat(Angles.difference(parts.headingRad(), whole.headingRad()))
        .isCloseTo(0, within(1e-9));
  }

  @Property
  void anAlmostStraightArcIsAlmostALine(
      @ForAll @DoubleRange(min = -1e-3, max = 1e-3) @Scale(9) double angular) {
    Pose straight = Kinematics.after(START, 250, 0, 1);
    Pose arc = Kinematics.after(START, 250, angular, 1);
    // To second order, the end lies aside by v w t^2 / 2.
    assertThat(arc.distanceMm(straight.at())).isCloseTo(125 * Math.abs(angular), within(1e-4));
  }
}
