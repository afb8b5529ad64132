package org.starl.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.cli.Main;
import org.starl.geometry.Obstacle;
import org.starl.input.BadInput;
import org.starl.sim.world.WaypointFile;
import org.starl.sim.world.WaypointFiles;

/** What {@code docs/input-files.md} says of waypoint files is what they do. */
class InputFilesDocTest {

  private static final Path PAGE = Path.of("../docs/input-files.md");
  private static final String FILE = "my.wpt";
  private static final Pattern REFUSED =
      Pattern.compile("\\| `([^`]+)` \\| `(my\\.wpt:1: [^`]+)` \\|");
  private static final Pattern WHOLE_FILE =
      Pattern.compile("\\| ([^|`]+) \\| `(my\\.wpt: [^`]+)` \\|");

  private static final Pattern DRAWING =
      Pattern.compile(
          "\\| `(<[^`]+|WAY,[^`]+)` \\| `drawing(\\.(?:svg:2|wpt:1): [^`]+?)(?: \\.\\.\\.)?` \\|");

  private static Map<String, String> rows(Pattern row) throws IOException {
    Map<String, String> rows = new TreeMap<>();
    Matcher matcher = row.matcher(Files.readString(PAGE));
    while (matcher.find()) {
      rows.put(matcher.group(1), matcher.group(2));
    }
    return rows;
  }

  @Test
  void eachLineThatIsSaidToBeRefusedPrintsItsMessage() throws IOException {
    Map<String, String> refused = rows(REFUSED);
    assertThat(refused).hasSizeGreaterThan(15);
    refused.forEach((line, message) ->
        assertThatThrownBy(() -> WaypointFiles.parse(FILE, line))
            .as(line)
            .isInstanceOf(BadInput.class)
            .hasMessage(message));
  }

  @Test
  void eachFileThatIsSaidToBeRefusedPrintsItsMessage(@TempDir Path folder) throws IOException {
    Path picture = folder.resolve("picture.wpt");
    Files.write(picture, new byte[] {(byte) 0x89, 'P', 'N', 'G', 0});
    List<String> messages = new ArrayList<>();
    for (Path bad : List.of(folder.resolve("nowhere.wpt"), folder, picture)) {
      assertThatThrownBy(() -> WaypointFiles.read(bad))
          .isInstanceOfSatisfying(
              BadInput.class,
              error ->
                  messages.add(String.valueOf(error.getMessage()).replace(bad.toString(), FILE)));
    }
    assertThat(rows(WHOLE_FILE).values()).containsExactlyInAnyOrderElementsOf(messages);
  }

  @Test
  void eachDrawingThatIsSaidToBeRefusedPrintsItsMessage(@TempDir Path folder) throws IOException {
    Map<String, String> refused = rows(DRAWING);
    assertThat(refused).hasSize(11);
    for (Map.Entry<String, String> row : refused.entrySet()) {
      boolean isSvg = row.getKey().startsWith("<");
      Path drawing = folder.resolve(isSvg ? "drawing.svg" : "drawing.wpt");
      String text = "<svg xmlns='http://www.w3.org/2000/svg'>\n" + row.getKey() + "\n</svg>\n";
      Files.writeString(drawing, isSvg ? text : row.getKey());
      StringWriter said = new StringWriter();
      PrintWriter out = new PrintWriter(said);
      Main.run(out, out, "run", "lightpaint", "--set", "drawing=" + drawing);
      assertThat(said.toString().lines())
          .singleElement()
          .asString()
          .startsWith("starl: " + folder.resolve("drawing") + row.getValue());
    }
  }

  @Test
  void theExampleIsReadAsThePageSays() throws IOException {
    StringBuilder example = new StringBuilder();
    for (String line : Files.readString(PAGE).split("\n", -1)) {
      if (line.startsWith("    ") && example.indexOf("Hidden") < 0) {
        example.append(line.strip()).append('\n');
      }
    }
    WaypointFile read = WaypointFiles.parse(FILE, example.toString());
    assertThat(read.waypoints()).hasSize(2);
    assertThat(read.waypoints().get(1).radiusMm()).hasValue(10);
    assertThat(read.sensePoints()).hasSize(1);
    assertThat(read.obstacles().all())
        .extracting(Obstacle::hidden, Obstacle::closed, Obstacle::lifetimeMs)
        .containsExactly(
            org.assertj.core.groups.Tuple.tuple(false, false, -1L),
            org.assertj.core.groups.Tuple.tuple(true, true, 30000L));
  }
}
