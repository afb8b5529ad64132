package org.starl.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Drawings in DXF become walls in mm. */
class DxfFileTest {

  /** A drawing in metres; each word is a line. */
  private static String drawing(String unit, String entities) {
    String header = "0 SECTION 2 HEADER 9 $INSUNITS 70 " + unit + " 0 ENDSEC 0 SECTION 2 ENTITIES ";
    return (header + entities + " 0 ENDSEC 0 EOF ").replace(" ", "\r\n");
  }

  private static List<Point> wall(String entity) {
    List<Obstacle> walls = DxfFile.parse("a.dxf", drawing("6", entity)).all();
    assertThat(walls).hasSize(1);
    assertThat(walls.get(0).closed() || walls.get(0).hidden()).isFalse();
    return walls.get(0).points();
  }

  private static Point p(double xMm, double yMm) {
    return new Point(xMm, yMm);
  }

  @Test
  void linesAndPolylinesKeepTheirCorners() {
    assertThat(wall("0 LINE 8 walls 10 0.5 20 -1 11 4 21 0"))
        .containsExactly(p(500, -1000), p(4000, 0));
    assertThat(wall("0 LWPOLYLINE 90 3 70 0 10 0 20 0 10 2 20 0 10 2 20 3"))
        .containsExactly(p(0, 0), p(2000, 0), p(2000, 3000));
    assertThat(wall("0 LWPOLYLINE 90 3 70 1 10 0 20 0 10 2 20 0 10 2 20 3"))
        .containsExactly(p(0, 0), p(2000, 0), p(2000, 3000), p(0, 0));
    assertThat(
            wall(
                "0 POLYLINE 66 1 10 0 20 0 70 0 0 VERTEX 10 1 20 3 0 VERTEX 10 1 20 4 0 SEQEND 8 0"))
        .containsExactly(p(1000, 3000), p(1000, 4000));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0 TEXT 10 0 20 0 1 Hall",
        "0 LINE 67 1 10 0 20 0 11 4 21 0", // of the paper space
        "0 HATCH 70 1"
      })
  void aDrawingWithoutWallsIsRefused(String entities) {
    assertThatThrownBy(() -> DxfFile.parse("a.dxf", drawing("6", entities)))
        .isInstanceOf(BadInput.class)
        .hasMessage(
            "a.dxf: has no wall: expected LINE, LWPOLYLINE, POLYLINE, ARC or CIRCLE in its model space");
  }

  /** A bulge of 1 is a half circle to the right of the way, which turns left. */
  @Test
  void arcsCirclesAndBulgesAreRound() {
    List<Point> bulge = wall("0 LWPOLYLINE 90 2 70 0 10 0 20 0 42 1 10 2 20 0");
    assertRound(bulge, p(1000, 0), 1000);
    assertThat(bulge.get(0)).isEqualTo(p(0, 0));
    assertThat(bulge.getLast()).isEqualTo(p(2000, 0));
    assertThat(bulge).allMatch(at -> at.yMm() <= 0);
    List<Point> left = wall("0 LWPOLYLINE 90 2 70 0 10 0 20 0 42 -0.41421356237 10 2 20 0");
    assertRound(left, p(1000, -1000), StrictMath.sqrt(2) * 1000);
    assertThat(left).allMatch(at -> at.yMm() >= 0);
    List<Point> arc = wall("0 ARC 10 5 20 5 40 1 50 270 51 0");
    assertRound(arc, p(5000, 5000), 1000);
    assertThat(arc).allMatch(at -> at.xMm() >= 4999.9 && at.yMm() <= 5000.1);
    assertThat(arc.getLast().distanceMm(p(6000, 5000))).isLessThan(1e-6);
    assertRound(wall("0 CIRCLE 10 8 20 8 40 0.5"), p(8000, 8000), 500);
  }

  private static void assertRound(List<Point> points, Point center, double radiusMm) {
    assertThat(points).hasSizeGreaterThan(3);
    for (int i = 0; i < points.size(); i++) {
      assertThat(points.get(i).distanceMm(center)).isCloseTo(radiusMm, within(1e-3));
      Point middle = i == 0 ? points.get(0) : points.get(i).plus(points.get(i - 1)).times(0.5);
      assertThat(middle.distanceMm(center)).isBetween(radiusMm - 5.001, radiusMm + 0.001);
      assertThat(i > 0 && points.get(i).equals(points.get(i - 1))).isFalse();
    }
  }

  /** CAD programs write such bulges for straight lines. */
  @Test
  void aBulgeOfAlmostZeroIsAStraightLine() {
    for (String bulge : List.of("1e-17", "-1e-17", "1e-320")) {
      assertThat(wall("0 LWPOLYLINE 90 2 70 0 10 0 20 0 42 " + bulge + " 10 2 20 0"))
          .containsExactly(p(0, 0), p(2000, 0));
    }
  }

  @Test
  void anArcTurnsOnceAtMost() {
    assertThat(wall("0 ARC 10 5 20 5 40 1 50 350 51 -350"))
        .hasSameSizeAs(wall("0 ARC 10 5 20 5 40 1 50 350 51 10"));
    assertThat(wall("0 ARC 10 5 20 5 40 1 50 0 51 1e6"))
        .hasSameSizeAs(wall("0 ARC 10 5 20 5 40 1 50 0 51 280"));
  }

  @Test
  void theFrameOfASplineIsNoWall() {
    String vertices =
        "0 VERTEX 10 0 20 0 70 16 0 VERTEX 10 9 20 9 70 16 0 VERTEX 10 1 20 1 70 8 0 VERTEX 10 2 20 1 70 8 ";
    assertThat(wall("0 POLYLINE 66 1 10 0 20 0 70 4 " + vertices + "0 SEQEND 8 0"))
        .containsExactly(p(1000, 1000), p(2000, 1000));
  }

  /** Their ends do not depend on the direction of the third axis. */
  @Test
  void linesMayBeDrawnFromBelow() {
    assertThat(wall("0 LINE 10 0 20 0 11 1 21 0 230 -1")).hasSize(2);
  }

  @Test
  void commentsMayStandAnywhere() {
    assertThat(wall("999 walls 0 LINE 10 0 20 0 999 0 11 1 21 0")).hasSize(2);
  }

  @Test
  void onlyTheSectionOfThisNameHasTheEntities() {
    String layer =
        "0 LAYER 2 ENTITIES 70 0 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 10 0 20 0 11 1 21 0";
    String text = drawing("4", layer).replaceFirst("ENTITIES", "TABLES");
    assertThat(DxfFile.parse("a.dxf", text).all()).hasSize(1);
    assertThatThrownBy(
            () -> DxfFile.parse("a.dxf", drawing("4", "0 BLOCK").replace("ENTITIES", "BLOCKS")))
        .hasMessage("a.dxf: has no section ENTITIES; expected a drawing in ASCII DXF");
  }

  @Test
  void textAndThePaperSpaceAreLeftOut() {
    assertThat(
            wall(
                "0 TEXT 10 0 20 0 40 2.5 1 door 0 LINE 67 1 10 0 20 0 11 4 21 0 0 LINE 10 0 20 0 11 1 21 0"))
        .containsExactly(p(0, 0), p(1000, 0));
  }

  @ParameterizedTest
  @CsvSource({"1, 25.4", "2, 304.8", "4, 1", "5, 10", "6, 1000", "14, 100"})
  void unitsAreReal(String unit, double mm) {
    Obstacle wall =
        DxfFile.parse("a.dxf", drawing(unit, "0 LINE 10 0 20 0 11 1 21 0")).all().get(0);
    assertThat(wall.points().get(1).xMm()).isEqualTo(mm);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          6 | 0 INSERT 2 B 10 1 20 1 | a.dxf:16: 'INSERT': expected LINE, LWPOLYLINE, POLYLINE, ARC or CIRCLE; explode
          6 | 0 LINE 10 zero 20 1 | a.dxf:18: 'zero': expected a number
          6 | 0 LINE 10 NaN 20 1 | a.dxf:18: 'NaN': expected a number
          6 | 0 LINE 10 5d 20 1 | a.dxf:18: '5d': expected a number
          6 | 0 LINE 10 5 20 1 11 2 | a.dxf:16: LINE: has no group 21: expected a number there
          6 | 0 CIRCLE 10 5 20 1 | a.dxf:16: CIRCLE: has no group 40: expected a number there
          6 | 0 ARC 10 5 20 1 40 1 50 0 | a.dxf:16: ARC: has no group 51: expected a number there
          6 | 0 CIRCLE 10 5 20 1 40 -1 | a.dxf:16: CIRCLE: expected a radius (group 40) above 0
          6 | 0 LWPOLYLINE 10 0 20 0 10 5 | a.dxf:16: corner 2 has no group 20: expected a number there
          6 | 0 LWPOLYLINE 10 0 20 0 42 1e9 10 5 20 0 | a.dxf:16: expected at most 100000 points of walls
          6 | 0 CIRCLE 10 0 20 0 40 1 210 0.6 220 0 230 0.8 | a.dxf:16: CIRCLE: expected it seen from above (group 230)
          6 | 0 EOF | a.dxf:16: 'EOF': expected ENDSEC, the end of the entities
          10 | 0 LINE 10 0 20 1 | a.dxf:8: '10': expected $INSUNITS 1 (inches), 2 (feet), 4 (mm), 5 (cm) or 6 (m)
          6 | 0 LINE 10 1e5 20 1 | a.dxf:18: '1e5': expected at most 10 km
          6 | 0 LINE x 0 20 1 | a.dxf:17: 'x': expected the number of a group
          6 | 0 POLYLINE 70 16 | a.dxf:16: POLYLINE: expected a line, no mesh
          6 | 0 CIRCLE 10 0 20 0 40 1 230 -1 | a.dxf:16: CIRCLE: expected it seen from above (group 230)
          0 | 0 LINE 10 0 20 1 | a.dxf: has no unit: expected $INSUNITS 1 (inches), 2 (feet), 4 (mm), 5 (cm) or 6 (m)
          """)
  void whatIsNotReadIsRefusedWithItsLine(String unit, String entities, String message) {
    assertThatThrownBy(() -> DxfFile.parse("a.dxf", drawing(unit, entities)))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(message);
  }

  @Test
  void theNameTellsADrawingFromAWaypointFile(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("Floor.DXF");
    Files.writeString(file, drawing("4", "0 LINE 10 0 20 0 11 1 21 0"));
    assertThat(WaypointFiles.obstacles(file).all()).hasSize(1);
    String latin = "\u00ef\u00bb\u00bf" + drawing("4", "0 LINE 8 W\u00e4nde 10 0 20 0 11 1 21 0");
    Files.write(file, latin.getBytes(StandardCharsets.ISO_8859_1));
    assertThat(WaypointFiles.obstacles(file).all()).as("release 2004").hasSize(1);
    assertThatThrownBy(() -> DxfFile.parse("a.dxf", "0\nSECTION\n"))
        .hasMessage("a.dxf:2: the file ends: expected a drawing in ASCII DXF, up to its line EOF");
    Files.write(file, new byte[] {'A', 0});
    assertThatThrownBy(() -> WaypointFiles.obstacles(file))
        .hasMessageContaining("is not text; expected a drawing in ASCII DXF");
  }
}
