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
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.fleet.robot.FleetFactory;
import org.starl.input.BadInput;

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
