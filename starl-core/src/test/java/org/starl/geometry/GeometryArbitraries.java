package org.starl.geometry;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

/** Points and regions on a floor of four by four metres. */
final class GeometryArbitraries {

  private GeometryArbitraries() {}

  static Arbitrary<Point> points() {
    return Combinators.combine(coordinates(), coordinates()).as(Point::new);
  }

  static Arbitrary<Region> regions() {
    return Arbitraries.oneOf(circles(), rectangles(), stars(), unions());
  }

  static Arbitrary<Region> circles() {
    return Combinators.combine(points(), lengths()).as(Circle::new);
  }

  static Arbitrary<Region> rectangles() {
    return Combinators.combine(points(), lengths(), lengths()).as(Rectangle::around);
  }

  /** Simple polygons: corners at growing angles around a centre, at any distances. */
  static Arbitrary<Region> stars() {
    return Combinators.combine(
            points(), Arbitraries.doubles().between(50, 900).list().ofMinSize(3).ofMaxSize(9))
        .as(GeometryArbitraries::star);
  }

  static Arbitrary<Region> unions() {
    return Arbitraries.oneOf(circles(), rectangles(), stars())
        .list()
        .ofMinSize(1)
        .ofMaxSize(4)
        .map(Union::new);
  }

  private static Region star(Point center, List<Double> radii) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < radii.size(); i++) {
      double angle = 2 * StrictMath.PI * i / radii.size();
      corners.add(
          center.plus(new Point(StrictMath.cos(angle), StrictMath.sin(angle)).times(radii.get(i))));
    }
    return new Polygon(corners);
  }

  private static Arbitrary<Double> coordinates() {
    return Arbitraries.doubles().between(-2000, 2000);
  }

  private static Arbitrary<Double> lengths() {
    return Arbitraries.doubles().between(0, 900);
  }
}
