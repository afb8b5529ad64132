package org.starl.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class RegionTest {

  private static final Region SQUARE = Rectangle.around(new Point(2250, 2250), 500, 500);
  private static final Region CORNER =
      Polygon.of(
          new Point(0, 0),
          new Point(300, 0),
          new Point(300, 100),
          new Point(100, 100),
          new Point(100, 300),
          new Point(0, 300));

  @Test
  void theBorderBelongsToTheRegion() {
    assertThat(SQUARE.contains(new Point(2500, 2300))).isTrue();
    assertThat(new Circle(new Point(0, 0), 5).contains(new Point(3, 4))).isTrue();
    assertThat(CORNER.contains(new Point(100, 200))).isTrue();
    assertThat(CORNER.contains(new Point(0, 0))).isTrue();
  }

  @Test
  void theNotchOfAPolygonIsOutside() {
    assertThat(CORNER.contains(new Point(200, 200))).isFalse();
    assertThat(CORNER.distanceMm(new Point(200, 150))).isEqualTo(50);
    assertThat(CORNER.contains(new Point(50, 250))).isTrue();
  }

  @Test
  void theDistanceFromACornerOfARectangleIsEuclidean() {
    assertThat(SQUARE.distanceMm(new Point(2530, 2540))).isEqualTo(50);
    assertThat(SQUARE.depthMm(new Point(2250, 2400))).isEqualTo(100);
  }

  @Test
  void nowhereIsInfinitelyFarAndEverywhereHasNoBorder() {
    Point any = new Point(1, 2);
    assertThat(new Nowhere().contains(any)).isFalse();
    assertThat(new Nowhere().distanceMm(any)).isInfinite();
    assertThat(new Nowhere().depthMm(any)).isZero();
    assertThat(new Everywhere().contains(any)).isTrue();
    assertThat(new Everywhere().distanceMm(any)).isZero();
    assertThat(new Everywhere().depthMm(any)).isInfinite();
  }

  @Test
  void invalidRegionsAreRefused() {
    Point o = new Point(0, 0);
    assertThatThrownBy(() -> new Circle(o, -1)).hasMessageContaining("radius -1.0");
    assertThatThrownBy(() -> new Circle(new Point(Double.NaN, 0), 1)).hasMessageContaining("NaN");
    assertThatThrownBy(() -> new Rectangle(2, 0, 1, 1)).hasMessageContaining("the smaller one");
    assertThatThrownBy(() -> new Union(List.of())).hasMessageContaining("Nowhere");
    assertThatThrownBy(() -> Polygon.of(o, new Point(1, 0))).hasMessageContaining("at least 3");
  }

  @Test
  void aSelfIntersectingPolygonIsRefused() {
    Point a = new Point(0, 0);
    Point b = new Point(10, 0);
    Point c = new Point(10, 10);
    Point d = new Point(0, 10);
    assertThatThrownBy(() -> Polygon.of(a, c, b, d)).hasMessageContaining("meet");
    assertThatThrownBy(() -> Polygon.of(a, b, new Point(5, 0))).hasMessageContaining("meet");
    assertThatThrownBy(() -> Polygon.of(a, a, b, c)).hasMessageContaining("meet");
    assertThat(Polygon.of(a, b, c, d)).isNotEqualTo(Polygon.of(d, c, b, a));
  }

  @Test
  void aBoundingRectangleIsTight() {
    List<Point> points = List.of(new Point(3, -1), new Point(-2, 5), new Point(0, 0));
    assertThat(Rectangle.around(points)).isEqualTo(new Rectangle(-2, -1, 3, 5));
    assertThat(Rectangle.around(points).widened(2)).isEqualTo(new Rectangle(-4, -3, 5, 7));
  }
}
