package org.starl.apps.lightpaint.view;

import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;
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
    return drawing(svg, false, false).lines();
  }

  private static SvgDrawing drawing(String svg, boolean isScaled, boolean hasOutlines) {
    byte[] bytes = svg.getBytes(StandardCharsets.UTF_8);
    return SvgDrawing.read("a.svg", bytes, new SvgDrawing.Reading(10, isScaled, 4, hasOutlines));
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

  @ParameterizedTest
  @ValueSource(
      strings = {
        "M 0 90 C 0 60 0 30 0 0 T 20 0",
        "M 0 90 C 0 60 0 30 0 0 t 20 0",
        "M 0 90 Q 0 45 0 0 S 10 0 20 0",
        "M 0 90 Q 0 45 0 0 s 10 0 20 0",
        "M 0 0 C 0 0 9 9 0 9 Z S 10 0 20 0",
        "M 0 0 q 0 0 9 9 z t 20 0"
      })
  void aSmoothCurveContinuesItsOwnKindOnly(String d) {
    List<Line> lines = read("<path stroke='red' d='%s'/>".formatted(d));
    List<Point> last = lines.get(lines.size() - 1).path().points();
    assertThat(last.subList(last.size() - 2, last.size()))
        .containsExactly(new Point(0, 1000), new Point(200, 1000));
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
        "<path stroke='red' d='M 0 0 L 5'/> | path, character 10, at '': expected a path",
        "<path d='M 0 0 X 5 5'/> | path, character 7, at 'X 5 5': expected a path",
        "<path d='M 0 0 A 1 1 0 2 0 5 5'/> | path, character 15, at '2 0 5 5': expected a path",
        "<line x1='one' y1='2'/> | <line> with x1='one': expected a value of SVG 1.1",
        "<rect width='-3' height='5'/> | <rect> with width='-3': expected a value",
        "<ellipse rx='3'/> | <ellipse> without ry: expected a value of SVG 1.1",
        "<use/> | <use> without xlink:href: expected a link to an element",
        "<polyline points='1,2 3'/> | <polyline> with points='1,2 3': expected numbers in pairs",
        "<g transform='scale(1'/> | <g> with transform='scale(1': expected transforms",
        "<line x2='5' stroke='redd'/> | stroke='redd': expected a colour",
        "<line x2='5' stroke-width='x'/> | stroke-width='x': expected a value",
        "<line x2='5' style='stroke=red'/> | style 'stroke=red': expected style rules",
        "<style>line:nth-child(2){stroke:red}</style> | style 'line:nth-child(2){stroke:red}':",
        "<style>line{stroke:var(--x)}</style> | style 'line{stroke:var(--x)}': expected style rules",
        "<style>line{transform:none}</style> | transform in a style sheet: expected it as an attribute",
        "<use href='#none'/> | <use> refers to '#none': expected an element of the drawing",
        "<use href='https://example.org/a.svg#a'/> | <use> refers to 'https://example.org/a.svg#a':",
        "<text x='1'>Hi</text> | <text> 'Hi': expected its outlines as paths",
        "<g id='a'><use href='#a'/></g> | <use> refers to '#a', which holds it: expected no link in a ring",
        "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g> | <use> refers to '#b', which holds it",
        "<line x1='1' x1='2'/> | attribute x1 is there twice: expected it once",
        "<line x2='5' stroke='red' stroke-width='-5'/> | <line stroke-width='-5' ",
        "<path stroke='red' d='L 1 1 2 2'/> | <path d='L 1 1 2 2' stroke='red'> cannot be drawn",
        "<marker id='m'><path d='M0 0 1 1' marker-end='url(#m)'/></marker>"
            + "<path d='M0 0 9 9' marker-end='url(#m)'/> | <path d='M0 0 1 1' marker-end='url(#m)'> cannot",
        "<symbol id='q' viewBox='0 0 x 9'/><use href='#q'/> | <svg ",
        "<g transform='scale(1e300)'><line x2='5' stroke='red'/></g> | a line is Infinity mm wide",
        "<g transform-origin='5 5'/> | <g transform-origin='5 5'>: expected the origin as",
        "<g style='transform-origin:center'/> | <g style='transform-origin:center'",
        "<a b=c/> | is not XML at character 6, after '<a b=': expected an SVG drawing"
      })
  void anErrorNamesFileAndLine(String inside, String expected) {
    assertThatThrownBy(() -> read(inside.strip()))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("a.svg:2: " + expected.strip())
        .hasMessageNotContaining("\n");
  }

  /** Each is a line from (0, 1000) to (50, 1000), in lime. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "<style>line{stroke:lime!important} .a{stroke:red}</style><line class='a' x2='5'/>",
        "<style>g>line.a{stroke:lime} line{stroke:red}</style><g><line class='a' x2='5'/></g>",
        "<style>@media print{line{stroke:red}} *{stroke:lime}</style><line x2='5'/>",
        "<line x2='5' stroke='#0f0f'/>",
        "<line x2='5' style='stroke: #00ff0080'/>",
        "<line x2='5' style='-inkscape-stroke:none;stroke:rgba(0, 255, 0, 0.5)'/>",
        "<line x2='5' stroke='rgb(0 255 0)' stroke-linecap='null'/>",
        "<line x2='5' stroke='red' style='stroke:light-dark(#00ff00, rgb(1, 2, 3))'/>",
        "<line x1='-5' style='transform:translate(5px, 0);stroke:lime'/>",
        "<line x2='2.5%' stroke='lime'/>",
        "<line x2='.3125em' stroke='lime'/>",
        "<line id='a' x2='9' display='none'/><use href='#a'/><line x2='5' stroke='lime'/>",
        "<defs id='a'><line x2='9'/></defs><use href='#a'/><line x2='5' stroke='lime'/>",
        "<g id='b'><use href='#a'/></g><defs><line id='a' display='none'/></defs>"
            + "<use href='#b'/><line x2='5' stroke='lime'/>",
        "<switch><g systemLanguage='xx'><text>x</text></g><line x2='5' stroke='lime'/></switch>",
        "<g visibility='hidden'><line x2='5' stroke='lime' visibility='visible'/></g>",
        "<line id='a' x2='5' stroke='lime' stroke-width='1' visibility='hidden'/>"
            + "<use href='#a' visibility='visible'/><line x2='5' stroke='#0f0'/>"
      })
  void stylesAreThoseOfABrowser(String inside) {
    List<Line> lines = read(inside);
    assertThat(lines).hasSize(1);
    assertThat(lines.get(0).ink()).isEqualTo(new Ink(0x00ff00, 10));
    assertThat(lines.get(0).path().points())
        .containsExactly(new Point(0, 1000), new Point(50, 1000));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "width='100%' height='100%' viewBox='0 0 30 20'| 300 200",
        "viewBox='0 0 30 20'| 300 200",
        "width='60' viewBox='0 0 30 20'| 600 400",
        "height='10mm' viewBox='0 0 30 20'| 15 10",
        "width='30mm' height='2cm' viewBox='0,0,30,20'| 30 20",
        "style='width:60px;height:40px' viewBox='0 0 30 20'| 600 400"
      })
  void aSizeIsThatOfTheWholeDrawing(String attributes, String size) {
    String svg =
        "<svg xmlns='http://www.w3.org/2000/svg' stroke='red' %s><line y1='20' x2='30'/></svg>"
            .formatted(attributes);
    Point end = drawing(svg, false, false).lines().get(0).path().end();
    assertThat((int) end.xMm() + " " + (int) end.yMm()).isEqualTo(size);
    assertThat(drawing(svg, true, false).lines().get(0).path().end().xMm())
        .isGreaterThanOrEqualTo(300);
  }

  @Test
  void whatIsNotPaintedIsNamed() {
    String svg =
        """
        <?xml-stylesheet href="b.css" type="text/css"?><!DOCTYPE svg [<!ENTITY red "#ff0000">]>
        <svg xmlns="http://www.w3.org/2000/svg" width="100" height="100">
        <style>@import url("https://example.org/a.css");</style>
        <image href="a.png"/>
        <clipPath id="c"><path d="M0 0h5v5"/></clipPath>
        <rect width="5" height="5" fill="&red;"/> <circle cx="5" cy="5" r="5"/>
        <g clip-path="url(#c)"><line x2="5" stroke="red" stroke-dasharray="1 1"/></g>
        <line x2="5" stroke="red" stroke-width="0"/>
        <link xmlns="http://www.w3.org/1999/xhtml" rel="stylesheet" href="a.css"/>
        </svg>\
        """;
    SvgDrawing drawing = drawing(svg, false, false);
    assertThat(drawing.lines()).hasSize(1);
    assertThat(drawing.notes())
        .containsExactly(
            "a.svg:4: <image> is not painted",
            "a.svg:7: a clip is not applied: lines are painted whole",
            "a.svg:6: a fill is not painted, 2 times",
            "a.svg:8: a shape without a visible stroke or fill is not painted",
            "a.svg:1: a style sheet outside of the file is not applied, 2 times",
            "a.svg:7: dashes are painted without gaps",
            "a.svg:2: https://example.org/a.css is not applied");
    assertThat(drawing(svg, false, true).lines())
        .extracting(line -> line.ink().rgb())
        .containsExactly(0xff0000, 0, 0xff0000);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<svg width='9' height='9'><line x2='%s'/></svg>",
        "<symbol id='a'><svg width='9' height='9'><line x2='%s'/></svg></symbol><use href='#a'/>"
      })
  void aLineBeyondAnEdgeIsPaintedAndNamed(String inside) {
    assertThat(notes(inside.formatted(9))).isEmpty();
    assertThat(notes(inside.formatted(12)))
        .containsExactly("a.svg:2: a clip is not applied: lines are painted whole");
  }

  @Test
  void aLineBeyondThePageIsPaintedAndNamed() {
    assertThat(notes("<line x2='101'/>"))
        .containsExactly("a.svg:1: a clip is not applied: lines are painted whole");
  }

  private static List<String> notes(String inside) {
    String head = "<svg xmlns='http://www.w3.org/2000/svg' stroke='red' width='100' height='100'>";
    return drawing(head + "\n" + inside + "</svg>", false, false).notes();
  }

  @Test
  void aStrokeThatDoesNotScaleHasItsWidth() {
    String line = "<g transform='scale(5)'><line x2='5' stroke='red' stroke-width='2' %s/></g>";
    assertThat(read(line.formatted("vector-effect='non-scaling-stroke'")).get(0).ink().widthMm())
        .isEqualTo(20);
    assertThat(read(line.formatted("")).get(0).ink().widthMm()).isEqualTo(100);
  }

  @Test
  void markersAreLinesAtTheirPlaces() {
    List<Line> lines =
        read(
            "<marker id='m' markerUnits='userSpaceOnUse' markerWidth='4' markerHeight='4'>"
                + "<line y2='4' stroke='lime'/></marker>"
                + "<path d='M 0 0 h 10 h 10' stroke='red' marker-mid='url(#m)' marker-end='url(#m)'/>");
    assertThat(lines)
        .extracting(line -> line.path().start())
        .containsExactly(new Point(0, 1000), new Point(100, 1000), new Point(200, 1000));
  }

  @Test
  void longListsOfPointsAreRead() {
    String points = "1,1 2,2 ".repeat(20_000);
    assertThat(read("<polyline stroke='red' points='" + points + "'/>")).hasSize(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<?xml version='1.0' encoding='x'?><svg/> | '<?xml version='1.0' encoding='x'?><svg/>'",
        "<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]><svg xmlns='http://www.w3.org/2000/svg'>&a;</svg> | is not XML at",
        "<svg xmlns='http://www.w3.org/2000/svg' width='0'/> | width=0: expected a size above 0",
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0,,0,5,5'/> | <svg "
      })
  void aWrongStartOfAFileIsNamed(String text, String expected) {
    assertThatThrownBy(() -> readFile(text.strip()))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("a.svg:1: " + expected.strip());
  }

  @Test
  void moreAttributesThanTheParserReadsAreRefused() {
    String attributes = IntStream.range(0, 300).mapToObj(i -> " a" + i + "='1'").collect(joining());
    assertThatThrownBy(() -> read("<g" + attributes + "/>"))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("a.svg:2: has more than is read");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "hello", "<html></html>", "<svg></svg>", "\0\1\2"})
  void aFileThatIsNoSvgIsRefused(String text) {
    assertThatThrownBy(() -> readFile(text))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("a.svg:1: ")
        .hasMessageContaining("an SVG drawing");
  }
}
