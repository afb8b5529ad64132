package org.starl.apps.fleet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.SortedMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.fleet.files.NavGraphs;
import org.starl.apps.fleet.robot.FleetFactory;
import org.starl.input.BadInput;
import org.starl.spec.SpecReport;

/** The fleet on floors and with deliveries from files. */
class FleetFilesTest {

  private static final FleetDemo DEMO = new FleetDemo();

  /** A home and two stations at a street. */
  private static final String BUILDING =
      """
      coordinate_system: cartesian_meters
      levels:
        L1:
          lanes:
            - [0, 1, {bidirectional: [4, true]}]
            - [1, 2, {bidirectional: [4, true]}]
            - [2, 3, {bidirectional: [4, true]}]
          vertices:
            - [-1, 0, 0, home, {is_parking_spot: [4, true]}]
            - [0, 0, 0, ""]
            - [0, 2, 0, pantry, {pickup_dispenser: [1, a]}]
            - [1, 2, 0, desk, {dropoff_ingestor: [1, b]}]
      """;

  @TempDir private Path folder = Path.of("");

  private Request request(String tasks) throws IOException {
    SortedMap<String, String> parameters = DEMO.defaults();
    Path map = Files.writeString(folder.resolve("b.building.yaml"), BUILDING);
    parameters.put("map", map.toString());
    parameters.put("tasks", Files.writeString(folder.resolve("d.task"), tasks).toString());
    return new Request(1, OptionalInt.of(1), parameters);
  }

  @Test
  void deliveriesOfAFileArriveOnTheFloorOfAFile() throws IOException {
    Request request = request("5s pantry desk\n");
    Plan plan = DEMO.plan(request, DEMO.defaultSettings(request).build());
    plan.simulation().name("fleet").seed(1).build().run();
    assertThat(plan.story().measures().completed()).isEqualTo(1);
    assertThat(plan.story().lines()).last().asString().startsWith("1 of 1 deliveries");
  }

  /** A corridor of 30 cells with two bays at each end. */
  private Request corridor(long seed, String trips) throws IOException {
    String bays = "@@.@." + "@".repeat(24) + ".@.@@\n";
    String walls = "@".repeat(34) + "\n";
    String map = walls + bays + "@" + ".".repeat(32) + "@\n" + bays + walls;
    Path file =
        Files.writeString(folder.resolve("c.map"), "type octile\nheight 5\nwidth 34\nmap\n" + map);
    SortedMap<String, String> parameters = DEMO.defaults();
    parameters.put("map", file.toString());
    parameters.put("range", "1000m");
    parameters.put("tasks", Files.writeString(folder.resolve("c.scen"), trips).toString());
    return new Request(seed, OptionalInt.of(2), parameters);
  }

  @Test
  void robotsStayOnTheirLanesInALongCorridor() throws IOException {
    String trips =
        """
        version 1
        0 c.map 34 5 4 1 29 3 0
        0 c.map 34 5 20 2 8 2 0
        1 c.map 34 5 29 1 4 3 0
        1 c.map 34 5 9 2 28 2 0
        """;
    for (long seed = 1; seed <= 3; seed++) {
      Request request = corridor(seed, trips);
      Plan plan = DEMO.plan(request, DEMO.defaultSettings(request).build());
      SpecReport spec = plan.simulation().name("fleet").seed(seed).build().run().spec();
      assertThat(spec.violations()).as("seed %s", seed).isEmpty();
      assertThat(plan.story().measures().completed()).isEqualTo(4);
    }
  }

  @Test
  void gridMapsAreReadInTheFormsOfOtherToolsAndRefusedWithTheirSize() throws IOException {
    Path narrow =
        Files.writeString(folder.resolve("n.map"), "# a corridor\nwidth 3\nheight 1\nmap\n...\n");
    assertThat(NavGraphs.read(narrow).vertices()).hasSize(3);
    String wide = "type octile\nheight 6\nwidth 2000\nmap\n";
    Path large =
        Files.writeString(folder.resolve("l.map"), wide + (".".repeat(2000) + "\n").repeat(6));
    assertThatThrownBy(() -> NavGraphs.read(large))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith("l.map: 12000 free cells: expected at most 10000");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          34 5 0 0 4 1 | c.scen:2: '0 0': expected a free cell of the map
          34 6 4 1 20 2 | c.scen:2: '6': expected a whole number from 5 to 5
          34 5 4 1 4 1 | c.scen:2: 'x4y3': expected two places that are not the same
          """)
  void tripsThatDoNotFitTheMapAreRefused(String columns, String message) throws IOException {
    Request request = corridor(1, "version 1\n0 c.map " + columns + " 0\n");
    assertThatThrownBy(() -> DEMO.defaultSettings(request))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith(message);
  }

  @Test
  void partsThatAreNotThereAreRefused() throws IOException {
    Request request = request("5s pantry attic\n");
    assertThatThrownBy(() -> DEMO.defaultSettings(request))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith(
            "d.task:1: 'attic': expected the name of a station of the graph, such as pantry");
    SortedMap<String, String> parameters = request("5s pantry desk\n").parameters();
    assertThatThrownBy(
            () -> new FleetFactory().program(new Request(1, OptionalInt.of(1), parameters)))
        .isInstanceOf(BadInput.class)
        .hasMessageEndingWith("expected none on robots without the simulator");
  }
}
