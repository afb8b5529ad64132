package org.starl.apps.lightpaint.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.lightpaint.robot.LightPaintFactory;
import org.starl.geometry.Point;
import org.starl.geometry.Rectangle;

/** The painters' homes. */
class PaintingTest {

  private static final double RADIUS_MM = 243;

  /** A tube has at most 31 parts of 1 m, for the way to the farthest stroke and around others. */
  private static final double REACH_MM = 15_000;

  @ParameterizedTest
  @ValueSource(ints = {1, 4, 64, 128, 150, 200})
  void homesAreApartAndNotFarFromTheDrawing(int painters) {
    Polyline line = new Polyline(List.of(new Point(0, 0), new Point(2000, 3000)));
    List<Stroke> strokes = List.of(new Stroke(0, line, new Ink(0, 10)));
    LightPaintFactory.checkPainters(painters);
    Painting painting = Painting.of(strokes, List.of(), painters, RADIUS_MM);
    Rectangle drawing = Rectangle.around(line.points());
    List<Point> homes = painting.homes();
    assertThat(homes).hasSize(painters);
    for (int i = 0; i < painters; i++) {
      Point home = homes.get(i);
      assertThat(painting.floor().depthMm(home)).isGreaterThan(RADIUS_MM);
      assertThat(drawing.distanceMm(home)).isBetween(2 * RADIUS_MM, REACH_MM);
      for (Point other : homes.subList(0, i)) {
        assertThat(home.distanceMm(other)).isGreaterThan(2 * RADIUS_MM + 2);
      }
    }
  }
}
