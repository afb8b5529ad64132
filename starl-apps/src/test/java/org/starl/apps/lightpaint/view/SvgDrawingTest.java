package org.starl.apps.lightpaint.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Lines of SVG files, in mm, y upwards, and the errors of files that are no drawings. */
class SvgDrawingTest {

  private static List<Line> read(String inside) {
    return readFile(
        "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'>\n"
            + inside
            + "\n</svg>");
  }

  private static List<Line> readFile(String svg) {
    return SvgDrawing.read("a.svg", svg.getBytes(StandardCharsets.UTF_8), 10, 4);
  }

  private static List<Point> points(String d) {
    List<Line> lines = read("<path stroke='red' fill='none' d='" + d + "'/>");
    assertThat(lines).as(d).hasSize(1);
    return lines.get(0).path().points();
  }

  @Test
  void lengthsAreInMillimetresAndTheYAxisPointsUp() {
    List<Line> lines =
        read("<line x1='1' y1='2' x2='30' y2='100' stroke='#ff8000' stroke-width='3'/>");
    assertThat(lines).hasSize(1);
    assertThat(lines.get(0).path().points()).containsExactly(new Point(10, 980), new Point(300, 0));
    assertThat(lines.get(0).ink()).isEqualTo(new Ink(0xff8000, 30));
  }

  /** As a browser draws it: a line without a length only if its ends are round or square. */
  @Test
  void whatIsShorterThanAMillimetreIsADot() {
    assertThat(points("M 0 100 h .04")).containsExactly(new Point(0, 0), new Point(1, 0));
    assertThat(points("M 0 100 a .1 .1 0 0 1 .1 .1 z")).hasSize(2);
    assertThat(read("<path stroke='red' d='M 0 100 h 0 M 5 5'/>")).isEmpty();
    assertThat(read("<path stroke='red' stroke-linecap='round' d='M 0 100 h 0'/>")).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "M 0 100 L 10 100; 0 0 100 0",
        "m 0 100 l 10 -5; 0 0 100 50",
        "M 0 100 10 90; 0 0 100 100",
        "M 0 100 H 10 V 80; 0 0 100 0 100 200",
        "m 0 100 h 10 v -20; 0 0 100 0 100 200",
        "M 0 100 L 10 100 L 10 90 Z; 0 0 100 0 100 100 0 0",
        "M0,100l10,0l0-10z; 0 0 100 0 100 100 0 0",
        "M 0 100 C 0 100 10 90 10 90; 0 0 100 100",
        "M 0 100 C 0 100 10 90 10 90 S 20 100 20 100; 0 0 100 100 200 0",
        "M 0 100 Q 5 95 10 90; 0 0 100 100",
        "M 0 100 Q 5 95 10 90 T 20 80; 0 0 200 200",
        "m 0 100 q 5 -5 10 -10 t 10 -10; 0 0 200 200"
      })
  void everyPathCommandIsRead(String d, String expected) {
    StringBuilder found = new StringBuilder();
    for (Point point : points(d)) {
      found.append(' ').append((int) point.xMm()).append(' ').append((int) point.yMm());
    }
    assertThat(found.toString().strip()).isEqualTo(expected.strip());
  }

  @Test
  void arcsAndCurvesAreFlattenedToTheTolerance() {
    // A half circle around (500, 0) mm, 400 mm wide.
    List<Point> half = points("M 10 100 A 40 40 0 0 1 90 100");
    assertThat(half.size()).isBetween(6, 24);
    for (Point point : half) {
      assertThat(point.distanceMm(new Point(500, 0))).isCloseTo(400, within(4.0));
    }
    for (int i = 1; i < half.size(); i++) {
      Point middle = half.get(i - 1).plus(half.get(i)).times(0.5);
      assertThat(middle.distanceMm(new Point(500, 0))).isCloseTo(400, within(4.0));
    }
    assertThat(points("M 10 100 a 40 40 0 1 1 1 -10").size()).isGreaterThan(8);
  }

  @Test
  void transformsGroupsStylesAndViewBoxesApply() {
    List<Line> lines =
        readFile(
            "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100' viewBox='0 0 100 50'>"
                + "<style>.thick { stroke: blue; stroke-width: 3 }</style>"
                + "<g transform='translate(10,20)'><g transform='rotate(90)' class='thick'>"
                + "<polyline points='0,0 10,0' fill='none'/></g></g></svg>");
    assertThat(lines).hasSize(1);
    // Two units to one of the view box: down from (10, 20) to (10, 30) of it.
    assertThat(lines.get(0).path().points())
        .containsExactly(new Point(200, 600), new Point(200, 400));
    assertThat(lines.get(0).ink()).isEqualTo(new Ink(0x0000ff, 60));
  }

  @Test
  void shapesGiveTheirOutlinesAndFillsAreIgnored() {
    assertThat(read("<rect x='1' y='1' width='5' height='4' fill='red'/>")).isEmpty();
    List<Line> box = read("<rect x='1' y='1' width='5' height='4' fill='red' stroke='lime'/>");
    assertThat(box).hasSize(1);
    assertThat(box.get(0).path().lengthMm()).isEqualTo(180);
    assertThat(read("<circle cx='20' cy='20' r='10' stroke='lime'/>").get(0).path().lengthMm())
        .isBetween(620.0, 629.0);
    assertThat(read("<line x1='1' y1='1' x2='9' y2='9' stroke='red' visibility='hidden'/>"))
        .isEmpty();
  }

  @Test
  void eachSubpathIsALine() {
    assertThat(read("<path stroke='red' d='M 0 0 h 10 z m 0 20 h 10 M 0 50 v 10'/>"))
        .extracting(line -> line.path().start())
        .containsExactly(new Point(0, 1000), new Point(0, 800), new Point(0, 500));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<path stroke='red' d='M 0 0 L 5'/> | a.svg:2: path, character 10, at '': expected a number",
        "<path d='M 0 0 X 5 5'/> | a.svg:2: path, character 7, at 'X 5 5': expected a command",
        "<path d='L 0 0'/> | a.svg:2: path, character 1, at 'L 0 0': expected M first",
        "<path d='M 0 0 A 1 1 0 2 0 5 5'/> | a.svg:2: path, character 14, at ' 2 0 5 5': expected a flag of an arc",
        "<line x1='one' y1='2'/> | a.svg:2: x1='one': expected a length",
        "<polyline points='1,2 34'/> | a.svg:2: points, character 7, at '': expected numbers in pairs",
        "<polyline points='1,2 3'/> | a.svg:2: points, character 6, at '': expected numbers in pairs",
        "<g> | a.svg:3: is not XML"
      })
  void anErrorNamesFileAndLine(String inside, String expected) {
    assertThatThrownBy(() -> read(inside.strip()))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith(expected.strip());
  }

  @Test
  void longListsOfPointsAreRead() {
    String points = "1,1 2,2 ".repeat(20_000);
    assertThat(read("<polyline stroke='red' points='" + points + "'/>")).hasSize(1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "hello", "<html></html>", "\0\1\2"})
  void aFileThatIsNoSvgIsRefused(String text) {
    assertThatThrownBy(() -> readFile(text))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("a.svg:1: ")
        .hasMessageContaining("an SVG drawing");
  }
}
