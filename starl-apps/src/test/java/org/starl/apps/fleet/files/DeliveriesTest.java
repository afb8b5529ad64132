package org.starl.apps.fleet.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.fleet.logic.Delivery;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Lists of deliveries. */
class DeliveriesTest {

  /** Stations 0, 1 and 2 are vertices 0, 2 and 3. */
  private static final NavGraph GRAPH =
      new NavGraph(
          List.of(
              place("pantry", true), place("hall", false), place("coe", true), place("lab", true)),
          List.of());

  @TempDir private Path folder = Path.of("");

  private static Vertex place(String name, boolean isStation) {
    return new Vertex(name, new Point(0, 0), false, isStation, false);
  }

  private List<Delivery> read(String text) throws IOException {
    return Deliveries.read(Files.writeString(folder.resolve("d.task"), text), GRAPH, 500);
  }

  @Test
  void namesAndTimesAreReadInTheOrderOfTime() throws IOException {
    assertThat(read("# first\n2min coe pantry\r\n1.5s pantry lab # a comment\n\n1500ms lab coe"))
        .containsExactly(
            new Delivery(1500, 0, 3), new Delivery(1500, 3, 2), new Delivery(120_000, 2, 0));
  }

  @Test
  void tasksHaveStepsAndNumbersOfStations() throws IOException {
    assertThat(read("2\n0\t1\t2\t0\t0\n7 2 0\n"))
        .containsExactly(new Delivery(0, 2, 3), new Delivery(3500, 3, 0));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          '' | : has no delivery; expected a list of deliveries
          5 coe lab | :1: '5': expected a duration with a unit (ns us ms s min h), such as 100ms
          5s coe attic | :1: 'attic': expected the name of a station of the graph, such as pantry
          5s hall coe | :1: 'hall': expected the name of a station of the graph, such as pantry
          5s coe coe | :1: 'coe': expected two places that are not the same
          5s coe | :1: '5s coe': expected TIME FROM TO, such as 90s pantry coe
          3;0 0 1;0 1 2 | :1: '3': expected the number of tasks, 2
          many | :1: 'many': expected a whole number from 1 to 10000000
          1;0 0 3 | :2: '3': expected a whole number from 0 to 2
          1;0 0 | :2: '0 0': expected STEP FROM TO or STEP FROM TO 0 0
          1;0 0 1 0 5 | :2: '5': expected a whole number from 0 to 0
          1;-1 0 1 | :2: '-1': expected a whole number from 0 to 100000000
          """)
  void badLinesAreTold(String text, String line) {
    assertThatThrownBy(() -> read(text.replace(';', '\n')))
        .isInstanceOf(BadInput.class)
        .hasMessage(folder.resolve("d.task") + line);
  }
}
