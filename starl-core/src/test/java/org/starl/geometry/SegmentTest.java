package org.starl.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class SegmentTest {

  private static Segment segment(double ax, double ay, double bx, double by) {
    return new Segment(new Point(ax, ay), new Point(bx, by));
  }

  @Provide
  Arbitrary<Point> points() {
    return GeometryArbitraries.points();
  }

  @Test
  void segmentsCrossIfTheyHaveACommonPoint() {
    Segment base = segment(0, 0, 10, 0);
    assertThat(base.crosses(segment(5, -5, 5, 5))).isTrue();
    assertThat(base.crosses(segment(5, 0, 5, 5))).as("touches").isTrue();
    assertThat(base.crosses(segment(10, 0, 20, 5))).as("shares an end").isTrue();
    assertThat(base.crosses(segment(8, 0, 20, 0))).as("overlaps").isTrue();
    assertThat(base.crosses(segment(11, 0, 20, 0))).as("on the same line").isFalse();
    assertThat(base.crosses(segment(5, 1, 5, 5))).isFalse();
    assertThat(base.crosses(segment(11, -5, 11, 5))).isFalse();
  }

  @Test
  void theDistanceOfSegmentsIsBetweenTheirNearestPoints() {
    assertThat(segment(0, 0, 10, 0).distanceMm(segment(13, 4, 20, 4))).isEqualTo(5);
    assertThat(segment(0, 0, 10, 0).distanceMm(segment(5, -5, 5, 5))).isZero();
  }

  @Test
  void aSegmentOfLengthZeroIsAPoint() {
    assertThat(segment(1, 1, 1, 1).distanceMm(new Point(4, 5))).isEqualTo(5);
    assertThat(segment(1, 1, 1, 1).nearest(new Point(4, 5))).isEqualTo(new Point(1, 1));
  }

  @Property
  void noPointOfTheSegmentIsNearerThanTheNearest(
      @ForAll("points") Point a, @ForAll("points") Point b, @ForAll("points") Point from) {
    Segment segment = new Segment(a, b);
    double distanceMm = segment.distanceMm(from);
    assertThat(segment.nearest(from).distanceMm(from)).isCloseTo(distanceMm, within(1e-9));
    for (int i = 0; i <= 100; i++) {
      Point on = a.plus(b.minus(a).times(i / 100.0));
      assertThat(on.distanceMm(from)).isGreaterThanOrEqualTo(distanceMm - 1e-9);
    }
  }

  @Property
  void crossingIsSymmetric(
      @ForAll("points") Point a,
      @ForAll("points") Point b,
      @ForAll("points") Point c,
      @ForAll("points") Point d) {
    Segment one = new Segment(a, b);
    Segment other = new Segment(c, d);
    assertThat(one.crosses(other)).isEqualTo(other.crosses(one));
    assertThat(one.distanceMm(other) == 0).isEqualTo(one.crosses(other));
  }
}
