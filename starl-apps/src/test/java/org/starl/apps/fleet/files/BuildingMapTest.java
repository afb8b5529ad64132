package org.starl.apps.fleet.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.lifecycle.AfterTry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Buildings of Open-RMF's traffic editor. */
class BuildingMapTest {

  @TempDir private Path folder = Path.of("");

  /** Properties make folders of their own, which JUnit does not remove. */
  @AfterTry
  void removeFolder() throws IOException {
    for (File file : folder.toFile().listFiles()) {
      Files.delete(file.toPath());
    }
    Files.delete(folder);
  }

  /** Two levels with lanes; 100 pixels are 5 m. Vertex 0 is of a wall. */
  static final String GOOD =
      """
      coordinate_system: reference_image
      levels:
        L0:
          vertices:
            - [0, 0, 0, ""]
        L1:
          lanes:
            - [1, 2, {bidirectional: [4, true], graph_idx: [2, 1], mutex: [1, hall], orientation: [1, ""]}]
            - [2, 3, {bidirectional: [4, false], graph_idx: [2, 1], mutex: [1, ""]}]
            - [3, 1, {bidirectional: [4, false], graph_idx: [2, 1]}]
            - [3, 4, {bidirectional: [4, false], graph_idx: [2, 1]}]
            - [1, 0, {bidirectional: [4, true], graph_idx: [2, 0]}]
          measurements:
            - [0, 1, {distance: [3, 4]}]
            - [0, 2, {distance: [3, 6]}]
          vertices:
            - [0, 0, 0, ""]
            - [100, 0, 0, pantry, {pickup_dispenser: [1, coke], is_parking_spot: [4, false]}]
            - [0, 100, 0, coe, {dropoff_ingestor: [1, coke], is_holding_point: [4, true]}]
            - [300, 400, 0, "", {mutex: [1, door]}]
            - [300, 500, 0, trap, {is_charger: [4, true]}]
        L2:
          lanes:
            - [0, 1, {bidirectional: [4, true], graph_idx: [2, 0]}]
          measurements:
            - [0, 1, {distance: [3, 1]}]
          vertices:
            - [0, 0, 0, a, {is_charger: [4, true], is_parking_spot: [4, true]}]
            - [0, 1, 0, b]
      name: building
      """;

  private NavGraph read(String text, NavGraphs.Choice choice) {
    try {
      return NavGraphs.read(Files.writeString(folder.resolve("b.building.yaml"), text), choice);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private NavGraph read(String text) {
    return read(text, NavGraphs.Choice.DEFAULT);
  }

  @Test
  void aLevelHasThePlacesAndLanesOfOneGraph() {
    NavGraph graph = read(GOOD);
    // The trap has no way back.
    assertThat(graph.vertices())
        .containsExactly(
            new Vertex("pantry", new Point(5000, 0), false, true, false),
            new Vertex("coe", new Point(0, -5000), false, true, true),
            new Vertex("v3", new Point(15_000, -20_000), false, false, false, "door"));
    assertThat(graph.lanes())
        .containsExactly(
            new Lane(0, 1, "hall"), new Lane(1, 0, "hall"), new Lane(1, 2, ""), new Lane(2, 0, ""));
    assertThat(graph.groups(new Lane(1, 2, "hall"))).containsExactly("door", "hall");
  }

  @Test
  void theLevelAndTheGraphCanBeChosen() {
    assertThat(read(GOOD, new NavGraphs.Choice("L2", -1, 1, 1)).vertices())
        .containsExactly(
            new Vertex("a", new Point(0, 0), true, true, true),
            new Vertex("b", new Point(0, -1000), false, true, false));
    assertThat(read(GOOD, new NavGraphs.Choice("L1", 0, 1, 1)).vertices())
        .extracting(Vertex::name)
        .containsExactly("pantry", "v0");
    assertThatThrownBy(() -> read(GOOD, new NavGraphs.Choice("L0", -1, 1, 1)))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith("b.building.yaml: level 'L0': expected one of L1, L2");
    assertThatThrownBy(() -> read(GOOD, new NavGraphs.Choice("", 3, 1, 1)))
        .hasMessageEndingWith(": graph '3': expected one of 0, 1, the graph_idx of levels.L1");
  }

  private static String walled(String wall) {
    return GOOD.replace(
        "      - [300, 500, 0, trap, {is_charger: [4, true]}]\n",
        "      - [300, 500, 0, trap, {is_charger: [4, true]}]\n"
            + "      - [-100, 0, 0, \"\"]\n"
            + "    walls:\n"
            + "      - "
            + wall
            + "\n");
  }

  @Test
  void wallsAreThoseOfTheLevel() {
    NavGraph graph = read(walled("[0, 5, {alpha: [3, 1]}]"));
    assertThat(graph.walls())
        .isEqualTo(Obstacles.of(Obstacle.wall(new Point(0, 0), new Point(-5000, 0))));
    assertThat(graph.vertices()).hasSize(3);
  }

  @Test
  void aLaneThroughAWallIsRefused() {
    assertThatThrownBy(() -> read(walled("[0, 4, {}]")))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("b.building.yaml:8: levels.L1.lanes[0]: ")
        .hasMessageEndingWith("expected a lane with a clearance of 250.0 mm to all walls");
  }

  @Test
  void namesOfPlacesWithoutOneAreTheirOwn() {
    NavGraph graph = read(GOOD.replace("coe", "v3"));
    assertThat(graph.vertices()).extracting(Vertex::name).containsExactly("pantry", "v3", "v3_");
  }

  /** Without stations in the file: named places but chargers. */
  @Test
  void namedPlacesAreStationsIfTheFileHasNone() {
    NavGraph graph =
        read(
            GOOD.replace("dropoff_ingestor: [1, coke]", "dropoff_ingestor: [1, \"\"]")
                .replace("[3, 4, {bidirectional: [4, false]", "[3, 4, {bidirectional: [4, true]"));
    assertThat(graph.vertices())
        .filteredOn(Vertex::isStation)
        .extracting(Vertex::name)
        .containsExactly("pantry", "coe");
  }

  @Property(tries = 50)
  void lengthsAreThoseOfTheMeasurements(
      @ForAll @DoubleRange(min = -5000, max = 5000) double x,
      @ForAll @DoubleRange(min = -5000, max = 5000) double y,
      @ForAll @DoubleRange(min = 1, max = 100) double metres)
      throws IOException {
    folder = Files.createTempDirectory("building");
    String text =
        """
        levels:
          L1:
            lanes: [[0, 1, {bidirectional: [4, true], graph_idx: [2, 0]}]]
            measurements: [[0, 1, {distance: [3, %s]}]]
            vertices: [[0, 0, 0, a], [%s, %s, 0, b]]
        """
            .formatted(metres, x, y + 6000);
    NavGraph graph = read(text);
    assertThat(graph.lengthMm(graph.lanes().get(0))).isCloseTo(metres * 1000, within(0.01));
    Point b = graph.vertices().get(1).at();
    assertThat(StrictMath.signum(b.xMm())).isEqualTo(StrictMath.signum(x));
    assertThat(b.yMm()).isNegative();
  }

  @Test
  void metresHaveNoScaleAndPointUp() {
    String text =
        GOOD.replace("reference_image", "cartesian_meters")
            + "parameters: {offset_x: [3, 100], offset_y: [3, 0]}\n";
    assertThat(read(text).vertices().get(1).at()).isEqualTo(new Point(-100_000, 100_000));
  }

  /** A hundredth of a degree in Singapore: 1113.2 m to the east and 1105.7 m to the north. */
  @Test
  void degreesAreMetresInThePlane() {
    String text =
        GOOD.replace("reference_image", "wgs84")
            .replace("[100, 0, 0, pantry", "[103.79, 1.29, 0, pantry")
            .replace("[0, 100, 0, coe", "[103.80, 1.29, 0, coe")
            .replace("[300, 400, 0", "[103.79, 1.30, 0")
            .replace("[300, 500, 0", "[103.80, 1.30, 0");
    NavGraph graph = read(text);
    Point pantry = graph.vertices().get(0).at();
    Point east = graph.vertices().get(1).at().minus(pantry);
    Point north = graph.vertices().get(2).at().minus(pantry);
    assertThat(east.xMm()).isCloseTo(1_112_900, within(500.0));
    assertThat(north.yMm()).isCloseTo(1_105_740, within(500.0));
    assertThat(List.of(east.yMm(), north.xMm())).containsOnly(0.0);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          reference_image | web_mercator | :1: coordinate_system: 'web_mercator': expected one of reference_image, cartesian_meters, wgs84
          [1, 2, { | [1, 5, { | :8: levels.L1.lanes[0][1]: '5': expected a whole number from 0 to 4
          [1, 2, { | [1, one, { | :8: levels.L1.lanes[0][1]: 'one': expected a whole number from 0 to 4
          [1, 2, { | [1, 1, { | :8: levels.L1.lanes[0]: a list of 3: expected a lane between two places that are at least 1 mm apart
          - [2, 3, {bidirectional: [4, false] | - [2, 3, {bidirectional: [4, maybe] | :9: levels.L1.lanes[1][2].bidirectional[1]: 'maybe': expected one of true, false, yes, no, on, off
          [2, 3, {bidirectional: [4, false] | [2, 3, {bidirectional: false | :9: levels.L1.lanes[1][2].bidirectional: 'false': expected [TYPE, VALUE]
          {bidirectional: [4, false], graph_idx: [2, 1], mutex: [1, ""]} | true | :9: levels.L1.lanes[1][2]: 'true': expected a mapping
          L0: | L3: 5\\n  L0: | :3: levels.L3: '5': expected a mapping
          graph_idx: [2, 0] | graph_idx: [2, -1] | :12: levels.L1.lanes[4][2].graph_idx[1]: '-1': expected a whole number from 0 to 1000
          distance: [3, 4] | distance: [3, 0] | :14: levels.L1.measurements[0][2].distance[1]: '0': expected a number from 1.0E-6 to 1.0E9
          distance: [3, 4] | length: [3, 4] | :14: levels.L1.measurements[0]: a list of 3: expected [FROM, TO, {distance: [3, METRES]}] between two places
          measurements: | rulers: | :6: levels.L1: a mapping: expected measurements: [FROM, TO, {distance: [3, METRES]}], the scale of the drawing
          [300, 400, 0 | [300, .nan, 0 | :20: levels.L1.vertices[3][1]: '.nan': expected a number from -1.0E9 to 1.0E9
          [300, 400, 0 | [300, 400000000, 0 | :20: levels.L1.vertices[3]: a list of 5: expected a place within 1000 km of the origin
          0, coe, | 0, pantry, | :19: levels.L1.vertices[2][3]: 'pantry': expected a name that no other place of the graph has
          - [100, 0, 0, pantry, | - [[100], 0, 0, pantry, | :18: levels.L1.vertices[1][0]: a list of 1: expected one value
          lanes: | roads: | :2: levels: a mapping: expected a level with lanes
          [4, true], graph_idx: [2, 1], mutex: [1, hall] | [4, false], graph_idx: [2, 1], mutex: [1, hall] | good
          """)
  void badPartsAreToldWithTheirLine(String good, String bad, String line) {
    String text = GOOD.replace(good, bad.replace("\\n", "\n"));
    assertThat(text).isNotEqualTo(GOOD);
    if (line.equals("good")) {
      assertThat(read(text).lanes()).hasSize(3);
      return;
    }
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInput.class)
        .hasMessage(folder.resolve("b.building.yaml") + line);
  }

  @Test
  void aGraphHasTwoPlacesWithWaysBothWays() {
    String text = GOOD.replace("[3, 1, {", "[2, 4, {").replace("[4, true]", "[4, false]");
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith(
            "b.building.yaml: expected two places with lanes from each to the other, and found none");
  }

  @Test
  void otherFilesAreRefused() {
    assertThatThrownBy(() -> read("app: hello\n"))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith(
            ":1: expected a building of Open-RMF (levels:), a map of map_server or Nav2 (image:) or a grid map (type octile)");
  }

  @Test
  void buildingsOfTooManyPlacesAreRefused() {
    StringBuilder text = new StringBuilder("levels:\n  L1:\n    vertices:\n");
    for (int i = 0; i <= 10_000; i++) {
      text.append("      - [").append(i).append(", 0]\n");
    }
    text.append("    lanes:\n");
    for (int i = 0; i < 10_000; i++) {
      text.append("      - [").append(i).append(", ").append(i + 1).append("]\n");
    }
    assertThatThrownBy(() -> read(text.toString()))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith(
            ":2: levels.L1: a mapping: expected at most 10000 places with lanes of one graph");
  }
}
