package org.starl.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

class RegionPropertyTest {

  private static final double ROUNDING_MM = 1e-6;
  private static final int DIRECTIONS = 64;

  @Provide
  Arbitrary<Point> points() {
    return GeometryArbitraries.points();
  }

  @Provide
  Arbitrary<Region> regions() {
    return GeometryArbitraries.regions();
  }

  @Property(tries = 100)
  void textForPeopleIsShortAndTheTextOfTheTraceIsWhole(@ForAll("regions") Region region) {
    Region many = new Union(Collections.nCopies(50, region));
    assertThat(many.toString()).hasSizeLessThan(140);
    assertThat(region.toString()).hasSizeLessThan(140);
    assertThat(RegionText.parse(RegionText.format(many))).isEqualTo(many);
  }

  @Property
  void theDistanceIsZeroExactlyInTheRegion(
      @ForAll("regions") Region region, @ForAll("points") Point point) {
    assertThat(region.distanceMm(point) == 0).isEqualTo(region.contains(point));
  }

  @Property
  void noPointNearerThanTheDistanceBelongsToTheRegion(
      @ForAll("regions") Region region, @ForAll("points") Point point) {
    double distanceMm = region.distanceMm(point);
    for (Point near : around(point, distanceMm - ROUNDING_MM)) {
      assertThat(region.contains(near)).as("%s", near).isFalse();
    }
  }

  @Property
  void somePointAtTheDistanceBelongsToTheRegion(
      @ForAll("regions") Region region, @ForAll("points") Point point) {
    // Walks down the distance, which is what it claims to be only if the walk ends at the region.
    Point at = point;
    double walkedMm = 0;
    for (int i = 0; i < 40 && region.distanceMm(at) > ROUNDING_MM; i++) {
      Point next = nearestOf(region, at, region.distanceMm(at));
      walkedMm += next.distanceMm(at);
      at = next;
    }
    assertThat(region.distanceMm(at)).isLessThan(0.1 * region.distanceMm(point) + ROUNDING_MM);
    assertThat(walkedMm).isLessThanOrEqualTo(1.1 * region.distanceMm(point) + ROUNDING_MM);
  }

  @Property
  void theDistanceChangesAtMostAsMuchAsThePoint(
      @ForAll("regions") Region region, @ForAll("points") Point a, @ForAll("points") Point b) {
    double change = Math.abs(region.distanceMm(a) - region.distanceMm(b));
    assertThat(change).isLessThanOrEqualTo(a.distanceMm(b) + ROUNDING_MM);
  }

  @Property
  void aDiscWithTheDepthAsRadiusIsInTheRegion(
      @ForAll("regions") Region region, @ForAll("points") Point point) {
    double depthMm = region.depthMm(point);
    if (!region.contains(point)) {
      assertThat(depthMm).isZero();
    }
    for (Point inside : around(point, depthMm - ROUNDING_MM)) {
      assertThat(region.contains(inside)).as("%s", inside).isTrue();
    }
  }

  @Property
  void aUnionContainsExactlyThePointsOfItsParts(
      @ForAll("regions") Region a, @ForAll("regions") Region b, @ForAll("points") Point point) {
    Region both = Union.of(a, b);
    assertThat(both.contains(point)).isEqualTo(a.contains(point) || b.contains(point));
    assertThat(both.distanceMm(point))
        .isEqualTo(Math.min(a.distanceMm(point), b.distanceMm(point)));
  }

  private static Iterable<Point> around(Point center, double radiusMm) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < DIRECTIONS && radiusMm > 0; i++) {
      double angle = 2 * StrictMath.PI * i / DIRECTIONS;
      for (double part : new double[] {0.3, 1}) {
        points.add(
            center.plus(
                new Point(StrictMath.cos(angle), StrictMath.sin(angle)).times(radiusMm * part)));
      }
    }
    return points;
  }

  private static Point nearestOf(Region region, Point center, double radiusMm) {
    Point best = center;
    for (int i = 0; i < 720; i++) {
      double angle = StrictMath.PI * i / 360;
      Point candidate =
          center.plus(new Point(StrictMath.cos(angle), StrictMath.sin(angle)).times(radiusMm));
      if (region.distanceMm(candidate) < region.distanceMm(best)) {
        best = candidate;
      }
    }
    return best;
  }
}
