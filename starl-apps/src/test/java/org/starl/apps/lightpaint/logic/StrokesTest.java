package org.starl.apps.lightpaint.logic;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;

/** How a drawing is cut into strokes. */
class StrokesTest {

  private static final Ink RED = new Ink(0xff0000, 20);
  private static final Ink BLUE = new Ink(0x0000ff, 20);

  private static Line line(Ink ink, double... xy) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < xy.length; i += 2) {
      points.add(new Point(xy[i], xy[i + 1]));
    }
    return new Line(new Polyline(points), ink);
  }

  private static List<Stroke> strokes(Line... lines) {
    return Strokes.of(List.of(lines), 10, 1000);
  }

  private static double lengthMm(List<Stroke> strokes) {
    return strokes.stream().mapToDouble(stroke -> stroke.path().lengthMm()).sum();
  }

  @Test
  void linesOfOneInkThatMeetBecomeOneStroke() {
    List<Stroke> one = strokes(line(RED, 0, 0, 100, 0), line(RED, 300, 0, 103, 0));
    assertThat(one).hasSize(1);
    assertThat(one.get(0).path().lengthMm()).isEqualTo(300);
    assertThat(strokes(line(RED, 0, 0, 100, 0), line(BLUE, 100, 0, 300, 0))).hasSize(2);
  }

  @Test
  void longChainsAreCutEvenlyAndClosedChainsAtLeastOnce() {
    assertThat(strokes(line(RED, 0, 0, 2500, 0)))
        .hasSize(3)
        .allMatch(stroke -> Math.abs(stroke.path().lengthMm() - 2500 / 3.0) < 1e-9);
    assertThat(strokes(line(RED, 0, 0, 50, 0, 50, 50, 0, 0))).hasSize(2);
  }

  @Test
  void aPlaceDrawnTwiceBelongsToTheLaterLine() {
    List<Stroke> strokes =
        strokes(line(RED, 0, 0, 800, 0), line(BLUE, 600, 0, 200, 0), line(RED, 0, 500, 9, 500));
    assertThat(lengthMm(strokes)).isBetween(788.0, 830.0);
    assertThat(
            strokes.stream()
                .filter(s -> s.ink().equals(BLUE))
                .mapToDouble(s -> s.path().lengthMm())
                .sum())
        .isEqualTo(400);
    assertThat(strokes(line(RED, 0, 0, 300, 0, 0, 0))).hasSize(1);
  }

  @Test
  void linesThatCrossOrMeetAtACornerKeepTheirLength() {
    List<Stroke> cross = strokes(line(RED, 0, 0, 400, 0), line(BLUE, 200, -200, 200, 200));
    assertThat(lengthMm(cross)).isEqualTo(800);
    List<Stroke> corner = strokes(line(RED, 0, 0, 400, 0), line(BLUE, 0, 0, 390, 110));
    assertThat(lengthMm(corner)).isGreaterThan(800);
  }

  /** A leg that is shorter than the width within which lines are one does not cover the next. */
  @Test
  void aLineWithShortLegsKeepsItsLength() {
    double[] ring = {10, 0, 7, 7, 0, 10, -7, 7, -10, 0, -7, -7, 0, -10, 7, -7, 10, 0};
    assertThat(lengthMm(strokes(line(RED, ring)))).isBetween(60.0, 62.0);
    double[] stairs = {0, 0, 6, 0, 6, 6, 12, 6, 12, 12, 18, 12, 18, 18, 24, 18, 24, 24};
    assertThat(strokes(line(RED, stairs))).hasSize(1);
    assertThat(lengthMm(strokes(line(RED, stairs)))).isEqualTo(48);
  }

  @Test
  void aShortLineIsAStroke() {
    assertThat(lengthMm(strokes(line(RED, 0, 0, 1, 0)))).isEqualTo(1);
    assertThat(lengthMm(strokes(line(RED, 0, 0, 1, 0, 0, 0)))).isGreaterThan(0);
  }

  /** The middle line is removed for the last one; it must not remove the first one as well. */
  @Test
  void ofThreeParallelLinesNoneIsLost() {
    List<Line> lines =
        List.of(line(RED, 0, 16, 800, 16), line(BLUE, 0, 8, 800, 8), line(RED, 0, 0, 800, 0));
    for (Line line : lines) {
      assertNear(line.path(), strokes(lines.toArray(Line[]::new)), 13);
    }
  }

  @Test
  void aJointIsBentOnlyWhereTheLinesAre() {
    assertThat(strokes(line(RED, 0, 0, 105, 0), line(RED, 95, 0, 200, 0)))
        .extracting(stroke -> stroke.path().points())
        .containsExactly(List.of(new Point(0, 0), new Point(200, 0)));
    List<Stroke> bent = strokes(line(RED, 0, 0, 100, 0), line(RED, 100, 9, 300, 9));
    assertThat(bent).hasSize(1);
    assertThat(bent.get(0).path().distanceMm(new Point(100, 9))).isLessThan(0.01);
  }

  @Test
  void aChainOfShortLinesKeepsItsCurve() {
    Line[] arc = new Line[60];
    for (int i = 0; i < arc.length; i++) {
      arc[i] = line(RED, 12 * i, i * i / 5, 12 * i + 12, (i + 1) * (i + 1) / 5);
    }
    List<Stroke> strokes = strokes(arc);
    for (Line line : arc) {
      assertNear(line.path(), strokes, 4);
    }
  }

  private static void assertNear(Polyline path, List<Stroke> strokes, double mm) {
    for (double at = 0; at <= path.lengthMm(); at += 7) {
      Point place = path.at(at);
      assertThat(strokes).anyMatch(stroke -> stroke.path().distanceMm(place) <= mm);
    }
  }

  /** Strokes cover the drawing, and nothing else. */
  @Property(tries = 200)
  void strokesCoverTheDrawingAndNothingElse(
      @ForAll @Size(min = 4, max = 40) List<@IntRange(min = 0, max = 60) Integer> numbers) {
    List<Line> lines = new ArrayList<>();
    for (int i = 0; i + 3 < numbers.size(); i += 4) {
      double[] at = new double[4];
      for (int j = 0; j < 4; j++) {
        at[j] = 50 * numbers.get(i + j);
      }
      if (at[0] != at[2] || at[1] != at[3]) {
        lines.add(line(i % 8 == 0 ? RED : BLUE, at));
      }
    }
    List<Stroke> strokes = Strokes.of(lines, 10, 1000);
    lines.forEach(line -> assertNear(line.path(), strokes, 13));
    for (Stroke stroke : strokes) {
      assertThat(stroke.path().lengthMm()).isLessThanOrEqualTo(1002);
      for (double mm = 0; mm <= stroke.path().lengthMm(); mm += 7) {
        Point place = stroke.path().at(mm);
        assertThat(lines).anyMatch(line -> line.path().distanceMm(place) <= 11);
      }
    }
  }

  /** 300 strokes of 1 m are 300 m; with a line more there are none, and no time is spent on it. */
  @Test
  void aDrawingThatIsTooLongIsNotCut() {
    List<Line> lines = new ArrayList<>();
    for (int i = 0; i < Strokes.MAX; i++) {
      lines.add(line(i % 2 == 0 ? RED : BLUE, 0, 100 * i, 1000, 100 * i));
    }
    assertThat(Strokes.of(lines, 10, 1000)).hasSize(Strokes.MAX);
    lines.add(line(RED, 0, -100, 1000, -100));
    assertThat(Strokes.of(lines, 10, 1000)).isEmpty();
  }
}
