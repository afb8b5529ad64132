package org.starl.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

final class WaypointFilesTest {

  /** {@code shared/data} beside the checkout, or in the folder {@code -Dstarl.shared}. */
  private static Path original() {
    String shared = System.getProperty("starl.shared", "../../shared");
    Path folder = Path.of(shared).resolve("data/starl-original");
    assumeTrue(Files.isDirectory(folder), "skipped: no folder " + folder + " (set -Dstarl.shared)");
    return folder;
  }

  @Test
  void everyFileOfTheOriginalStarLIsRead() throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(original())) {
      files = all.filter(path -> path.toString().endsWith(".wpt")).sorted().toList();
    }
    assertThat(files).hasSizeGreaterThan(12);
    for (Path file : files) {
      WaypointFile read = WaypointFiles.read(file);
      int things =
          read.waypoints().size() + read.sensePoints().size() + read.obstacles().all().size();
      assertThat(things).as(file.toString()).isPositive();
    }
  }

  @Test
  void theOriginalIntersectionFileIsReadCompletely() {
    Path folder = original().resolve("intersection");
    WaypointFile goals = WaypointFiles.read(folder.resolve("dest.wpt"));
    assertThat(goals.waypoints()).hasSize(22);
    Waypoint last = goals.waypoints().get(21);
    assertThat(last.name()).isEqualTo("N");
    assertThat(last.angle()).isEqualTo(3);
    assertThat(last.radiusMm()).hasValue(10);
    WaypointFile obstacles = WaypointFiles.read(folder.resolve("obstacles.wpt"));
    assertThat(obstacles.obstacles().all()).hasSize(16).noneMatch(Obstacle::closed);
    WaypointFile starts = WaypointFiles.read(folder.resolve("start.wpt"));
    assertThat(starts.waypoints().get(3).position().pose().headingRad())
        .isEqualTo(-StrictMath.PI / 2);
  }

  @Test
  void theOriginalMazeIsHiddenAndTheOriginalSearchHasObjects() {
    Path folder = original();
    WaypointFile maze = WaypointFiles.read(folder.resolve("maze/obstacles.wpt"));
    assertThat(maze.obstacles().all()).hasSize(9).allMatch(Obstacle::hidden);
    WaypointFile search = WaypointFiles.read(folder.resolve("search/senseObjects.wpt"));
    assertThat(search.sensePoints())
        .extracting(Waypoint::name, Waypoint::xMm)
        .containsExactly(org.assertj.core.groups.Tuple.tuple("object1", 11000.0));
    WaypointFile bike = WaypointFiles.read(folder.resolve("lightpaint/bike.wpt"));
    assertThat(bike.waypoints().get(0).angle()).isEqualTo(16772608);
  }

  @Test
  void eachKindOfLineIsRead() {
    WaypointFile read =
        WaypointFiles.parse(
            "all.wpt",
            "// a comment\r\nWAY, 1.5,-2,90,A\r\n\r\n  WAY,3,4,0,B,10\n"
                + "SENSE,5,6,7,object\nObstacle;0,0;0,5000;-1\nHidden;0,0;1,0;1,1;2500");
    assertThat(read.waypoints()).extracting(Waypoint::name).containsExactly("A", "B");
    assertThat(read.waypoints().get(0).position().at()).isEqualTo(new Point(1.5, -2));
    assertThat(read.waypoints().get(0).radiusMm()).isEmpty();
    assertThat(read.sensePoints()).hasSize(1);
    assertThat(read.obstacles().all())
        .containsExactly(
            Obstacle.wall(new Point(0, 0), new Point(0, 5000)),
            new Obstacle(
                List.of(new Point(0, 0), new Point(1, 0), new Point(1, 1)), true, true, 2500));
    assertThat(WaypointFiles.parse("empty.wpt", "")).isEqualTo(WaypointFile.EMPTY);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "WALL,0,0,1,1 | expected WAY,x,y,angle,name[,radius] or SENSE,",
        "way,1,2,3,A | expected WAY,x,y,angle,name[,radius] or",
        "WAY,1,2,3 | expected WAY,x,y,angle,name[,radius]",
        "WAY,1,2,3, | expected WAY,x,y,angle,name[,radius]",
        "WAY,1,2,3,A,10,9 | expected WAY,x,y,angle,name[,radius]",
        "WAY,one,2,3,A | expected WAY,x,y,angle,name[,radius], but 'one' is not a number",
        "WAY,NaN,2,3,A | but 'NaN' is not a number",
        "WAY,1,2,3,A,-1 | with a radius of at least 0",
        "SENSE,1,,3,A | expected SENSE,x,y,angle,name[,radius], but '' is not a number",
        "Obstacle;0,0;-1 | with two corners or more",
        "Obstacle;0,0;1;-1 | but '1' is not x,y",
        "Obstacle;0,0;1,x;-1 | but 'x' is not a number",
        "Obstacle;0,0;1,1;soon | with a lifetime in whole ms, or -1 for ever",
        "Obstacle;0,0;9,9;9,0;0,9;-1 | around a body whose sides do not cross or touch",
        "Hidden;0,0;1,1;-2 | with a lifetime in whole ms, or -1 for ever",
        "Hidden;0,0;1,1 | expected Hidden;x,y;x,y[;x,y];lifetime with two corners or more"
      })
  void theErrorNamesTheBrokenLineAndTheExpectation(String line, String expected) {
    assertThatThrownBy(() -> WaypointFiles.parse("maze.wpt", "// first\n\n" + line + "\n"))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith("maze.wpt:3: '" + line + "': expected ")
        .hasMessageContaining(expected)
        .hasMessageNotContaining("\n");
  }

  @Test
  void aBinaryFileIsRefusedInOneLine(@TempDir Path folder) throws IOException {
    Path picture = folder.resolve("picture.wpt");
    Files.write(picture, new byte[] {(byte) 0x89, 'P', 'N', 'G', 0, (byte) 0xFF});
    Path zeros = folder.resolve("zeros.wpt");
    Files.write(zeros, new byte[100]);
    assertThatThrownBy(() -> WaypointFiles.read(picture))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith(picture + ": is not text; expected a waypoint file");
    assertThatThrownBy(() -> WaypointFiles.read(zeros)).hasMessageContaining("is not text");
    assertThatThrownBy(() -> WaypointFiles.read(folder)).hasMessageContaining("is a folder");
    assertThatThrownBy(() -> WaypointFiles.read(folder.resolve("missing.wpt")))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("missing.wpt: no such file; expected a waypoint file");
  }
}
