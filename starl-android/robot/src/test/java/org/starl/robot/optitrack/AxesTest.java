package org.starl.robot.optitrack;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;

/** What a stream's numbers mean on our floor. */
class AxesTest {

  private static final double HALF = StrictMath.sqrt(0.5);
  private static final double QUARTER_TURN = StrictMath.PI / 2;

  /** Of a body at (1, 2, 3) metres of the stream, turned by a quaternion. */
  private static RigidBodyState body(double qx, double qy, double qz, double qw) {
    return new RigidBodyState(7, 1, 2, 3, qx, qy, qz, qw, 0, true);
  }

  private static void assertPose(Axes axes, RigidBodyState body, double x, double y, double rad) {
    Pose pose = axes.pose(body);
    assertThat(pose).isNotNull();
    assertThat(pose.xMm()).isCloseTo(x, within(1e-9));
    assertThat(pose.yMm()).isCloseTo(y, within(1e-9));
    assertThat(Angles.difference(pose.headingRad(), rad)).isCloseTo(0, within(1e-9));
  }

  @Test
  void withZUpTheFloorIsXAndY() {
    Axes axes = new Axes(UpAxis.Z, BodyAxis.PLUS_X);
    assertPose(axes, body(0, 0, 0, 1), 1000, 2000, 0);
    assertThat(axes.heightMm(body(0, 0, 0, 1))).isEqualTo(3000);
  }

  @Test
  void withYUpTheFloorIsXAndMinusZ() {
    Axes axes = new Axes(UpAxis.Y, BodyAxis.PLUS_X);
    assertPose(axes, body(0, 0, 0, 1), 1000, -3000, 0);
    assertThat(axes.heightMm(body(0, 0, 0, 1))).isEqualTo(2000);
  }

  @Test
  void aQuarterTurnAboutTheUpAxisIsCounterClockwise() {
    assertPose(
        new Axes(UpAxis.Z, BodyAxis.PLUS_X), body(0, 0, HALF, HALF), 1000, 2000, QUARTER_TURN);
    assertPose(
        new Axes(UpAxis.Y, BodyAxis.PLUS_X), body(0, HALF, 0, HALF), 1000, -3000, QUARTER_TURN);
  }

  @Test
  void theForwardAxisIsASetting() {
    assertPose(new Axes(UpAxis.Z, BodyAxis.MINUS_X), body(0, 0, 0, 1), 1000, 2000, StrictMath.PI);
    assertPose(new Axes(UpAxis.Z, BodyAxis.PLUS_Y), body(0, 0, 0, 1), 1000, 2000, QUARTER_TURN);
    assertPose(new Axes(UpAxis.Z, BodyAxis.MINUS_Y), body(0, 0, 0, 1), 1000, 2000, -QUARTER_TURN);
    assertPose(new Axes(UpAxis.Y, BodyAxis.PLUS_Z), body(0, 0, 0, 1), 1000, -3000, -QUARTER_TURN);
    assertPose(new Axes(UpAxis.Y, BodyAxis.MINUS_Z), body(0, 0, 0, 1), 1000, -3000, QUARTER_TURN);
  }

  @Test
  void aForwardAxisThatPointsUpIsRefused() {
    assertThatThrownBy(() -> new Axes(UpAxis.Y, BodyAxis.MINUS_Y))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("MINUS_Y");
    assertThatThrownBy(() -> new Axes(UpAxis.Z, BodyAxis.PLUS_Z))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void anImpossiblePoseIsRefused() {
    Axes axes = new Axes(UpAxis.Z, BodyAxis.PLUS_X);
    // It stands on its nose: x points down.
    assertThat(axes.pose(body(0, HALF, 0, HALF))).isNull();
    assertThat(axes.pose(body(0, 0, 0, 0))).isNull();
    assertThat(axes.pose(body(0, 0, 0, 2))).isNull();
    assertThat(axes.pose(body(0, Double.NaN, 0, 1))).isNull();
    assertThat(axes.pose(new RigidBodyState(1, Double.NaN, 0, 0, 0, 0, 0, 1, 0, true))).isNull();
    assertThat(axes.pose(new RigidBodyState(1, 0, 1e30, 0, 0, 0, 0, 1, 0, true))).isNull();
    double infinite = Double.NEGATIVE_INFINITY;
    assertThat(axes.pose(new RigidBodyState(1, 0, 0, infinite, 0, 0, 0, 1, 0, true))).isNull();
  }

  @Property(tries = 300)
  void aStreamedPoseIsReadBack(
      @ForAll("allAxes") Axes axes,
      @ForAll @DoubleRange(min = -1e6, max = 1e6) double xMm,
      @ForAll @DoubleRange(min = -1e6, max = 1e6) double yMm,
      @ForAll @DoubleRange(min = -10, max = 10) double headingRad) {
    RigidBodyState state = axes.state(1, new Pose(xMm, yMm, headingRad), 55, 0, true);
    Pose back = axes.pose(state);
    assertThat(back).isNotNull();
    assertThat(back.xMm()).isCloseTo(xMm, within(1e-6));
    assertThat(back.yMm()).isCloseTo(yMm, within(1e-6));
    assertThat(Angles.difference(back.headingRad(), headingRad)).isCloseTo(0, within(1e-9));
    assertThat(axes.heightMm(state)).isCloseTo(55, within(1e-9));
  }

  @Provide
  Arbitrary<Axes> allAxes() {
    return Arbitraries.of(all());
  }

  static List<Axes> all() {
    List<Axes> all = new ArrayList<>();
    for (UpAxis up : UpAxis.values()) {
      for (BodyAxis forward : BodyAxis.values()) {
        if (up == UpAxis.Y ? forward.y == 0 : forward.z == 0) {
          all.add(new Axes(up, forward));
        }
      }
    }
    return all;
  }
}
