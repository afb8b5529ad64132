package org.starl.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.input.BadInput;
import org.starl.random.Rng;

/** Grid maps are read, and errors name every bad line. */
class GridMapsTest {

  private static final String SMALL =
      """
      type octile
      height 3
      width 4
      map
      @@@.
      .TG.
      ..OW
      """;

  @Test
  void theFirstLineOfAMapIsItsTopRow() {
    GridMap map = GridMaps.parse("small.map", SMALL);
    assertThat(map.columns()).isEqualTo(4);
    assertThat(map.rows()).isEqualTo(3);
    assertThat(map.isFree(0, 0)).isTrue();
    assertThat(map.isFree(2, 0)).isFalse();
    assertThat(map.isFree(3, 0)).isFalse();
    assertThat(map.isFree(2, 1)).isTrue();
    assertThat(map.isFree(3, 2)).isTrue();
    assertThat(map.isFree(0, 2)).isFalse();
    assertThat(map.isFree(-1, 0) || map.isFree(4, 0) || map.isFree(0, 3)).isFalse();
    assertThat(map.freeCells()).isEqualTo(6);
  }

  @Test
  void lineEndingsAndTrailingBlankLinesAreIgnored() {
    assertThat(GridMaps.parse("a", SMALL.replace("\n", "\r\n") + "\n\n").freeCells()).isEqualTo(6);
  }

  @Test
  void headersMayHaveTabsCommentsAndTheWidthFirst() {
    String other = "# from a benchmark\n\n// sizes\nwidth\t4 \nheight 3\t\n; rows\nmap \n";
    String rows = SMALL.substring(SMALL.indexOf("@@@")).replace("\n", " \n");
    for (String type : List.of("", "type\toctile\n")) {
      GridMap map = GridMaps.parse("a", type + other + rows);
      assertThat(List.of(map.columns(), map.rows(), map.freeCells())).containsExactly(4, 3, 6);
      assertThat(map.isFree(3, 2)).isTrue();
    }
    assertThatThrownBy(() -> GridMaps.parse("a", other + rows.replace(".TG.", ".TG")))
        .hasMessage(
            "a:9: '.TG': expected cells . G S (free) or @ O T W (blocked), not ' ' in column 4");
    assertThatThrownBy(() -> GridMaps.parse("a", other + rows.replace(".TG.", "   .")))
        .hasMessage(
            "a:9: '.': expected cells . G S (free) or @ O T W (blocked), not ' ' in column 1");
    assertThatThrownBy(() -> GridMaps.parse("a", other + rows + "..."))
        .hasMessage("a:11: '...': expected only the 3 rows of line 5");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          type octile | type tile   | small.map:1: 'type tile': expected 'type octile'
          height 3    | height x    | small.map:2: 'height x': expected 'height N' with N from 1 to 2048
          height 3    | height 0    | small.map:2: 'height 0': expected 'height N' with N from 1 to 2048
          height 3    | height 9999 | small.map:2: 'height 9999': expected 'height N' with N from 1 to 2048
          width 4     | height 4    | small.map:3: 'height 4': expected 'width N' with N from 1 to 2048
          map         | maps        | small.map:4: 'maps': expected 'map'
          .TG.        | .TG         | small.map:6: '.TG': expected 4 cells as in line 3, not 3
          .TG.        | .T?.        | small.map:6: '.T?.': expected cells . G S (free) or @ O T W (blocked), not '?' in column 3
          height 3    | height 4    | small.map:8: '': expected 4 cells as in line 3, not 0
          height 3    | height 2    | small.map:7: '..OW': expected only the 2 rows of line 2
          """)
  void theErrorNamesTheBadLine(String good, String bad, String message) {
    assertThatThrownBy(() -> GridMaps.parse("small.map", SMALL.replace(good, bad)))
        .isInstanceOf(BadInput.class)
        .hasMessage(message);
  }

  @Test
  void missingAndBinaryFilesAreReported(@TempDir Path folder) throws Exception {
    Path missing = folder.resolve("a.map");
    assertThatThrownBy(() -> GridMaps.read(missing)).hasMessageContaining("a.map: no such file");
    assertThatThrownBy(() -> GridMaps.read(folder)).hasMessageContaining("is a folder");
    Files.write(missing, new byte[] {(byte) 0xFF, (byte) 0xFE, 0, 0});
    assertThatThrownBy(() -> GridMaps.read(missing)).hasMessageContaining("is not text");
    assertThatThrownBy(() -> GridMaps.parse("empty.map", ""))
        .hasMessage("empty.map:2: the file ends: expected 'height N' with N from 1 to 2048");
  }

  @Property(tries = 200)
  void theWallsCoverExactlyTheBlockedCells(@ForAll long seed) {
    Rng rng = new Rng(seed);
    int columns = 1 + rng.nextInt(9);
    int rows = 1 + rng.nextInt(9);
    StringBuilder text = new StringBuilder("type octile\nheight " + rows + "\nwidth " + columns);
    text.append("\nmap\n");
    for (int i = 0; i < rows; i++) {
      for (int j = 0; j < columns; j++) {
        text.append(rng.nextBoolean(0.6) ? '@' : '.');
      }
      text.append('\n');
    }
    GridMap map = GridMaps.parse("drawn.map", text.toString());
    Obstacles walls = map.walls(500);
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        Point middle = new Point((column + 0.5) * 500, (row + 0.5) * 500);
        double expectedMm = map.isFree(column, row) ? 250 : 0;
        assertThat(walls.distanceMm(middle)).isGreaterThanOrEqualTo(expectedMm);
        assertThat(walls.distanceMm(middle) == 0).isEqualTo(!map.isFree(column, row));
      }
    }
    long covered = 0;
    for (var wall : walls.all()) {
      Point low = wall.points().get(0);
      Point high = wall.points().get(2);
      covered += Math.round((high.xMm() - low.xMm()) * (high.yMm() - low.yMm()) / 250_000);
    }
    assertThat(covered).isEqualTo((long) columns * rows - map.freeCells());
  }

  @ParameterizedTest
  @CsvSource({
    "empty-48-48, 48, 48, 2304, 0",
    "maze-32-32-4, 32, 32, 790, 40",
    "room-32-32-4, 32, 32, 682, 140",
    "random-64-64-20, 64, 64, 3270, 700",
    "den312d, 65, 81, 2445, 160",
    "ht_chantry, 162, 141, 7461, 220",
    "Berlin_1_256, 256, 256, 47540, 1300"
  })
  void theBenchmarkMapsLoad(String name, int columns, int rows, int free, int mostWalls) {
    Path folder = Path.of(System.getProperty("starl.shared", "../../shared")).resolve("data/maps");
    assumeTrue(Files.isDirectory(folder), "skipped: no folder " + folder + " (-Dstarl.shared)");
    GridMap map = GridMaps.read(folder.resolve(name + ".map"));
    assertThat(map.columns()).isEqualTo(columns);
    assertThat(map.rows()).isEqualTo(rows);
    assertThat(map.freeCells()).isEqualTo(free);
    assertThat(map.walls(500).all()).hasSizeLessThanOrEqualTo(mostWalls);
  }
}
