package org.starl.cli.deploy;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** {@code starl deploy plan}: the floor to tape. */
class DeployPlanTest {

  private static final String SHIPPED = "../scenarios/deployment/";
  private static final Pattern FLOOR =
      Pattern.compile("floor: .* mm, x from (-?\\d+) to (-?\\d+), y from (-?\\d+) to (-?\\d+)");
  private static final Pattern BODY =
      Pattern.compile("starts at x (-?\\d+) y (-?\\d+) mm, heading (-?\\d+) deg, radius (\\d+) mm");

  @TempDir private Path folder;

  @Test
  void theFourCarsHaveStartsZonesAxesAndEnds() {
    Cli cli = Cli.run("deploy", "plan", SHIPPED + "crossing.yaml");

    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text())
        .contains("bot0: starts at x 1700 y 2250 mm, heading 0 deg, radius 165 mm; ends at x ")
        .contains("bot1: starts at x 2750 y 1700 mm, heading 90 deg")
        .contains("area A: x from 2000 to 2500, y from 2500 to 3000")
        .contains("those of the cameras, where y is called -z; headings counter-clockwise from x")
        .contains("[bot0, bot2] end at one place: lift each off the floor when it has ended");
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"crossing", "lightpaint", "search"})
  void theFloorHasRoomForEveryBodyAndBothDrawings(String name) throws Exception {
    Path svg = folder.resolve(name + ".svg");
    Path pdf = folder.resolve(name + ".pdf");
    Cli cli =
        Cli.line(Apps.ALL, "deploy plan " + SHIPPED + name + ".yaml", "--svg", svg, "--pdf", pdf);

    assertThat(cli.status()).as("%s", cli).isZero();
    List<int[]> bodies = new ArrayList<>();
    Matcher floor = FLOOR.matcher(cli.out().get(0));
    assertThat(floor.matches()).as(cli.out().get(0)).isTrue();
    Matcher body = BODY.matcher(cli.text());
    while (body.find()) {
      int x = Integer.parseInt(body.group(1));
      int y = Integer.parseInt(body.group(2));
      int radius = Integer.parseInt(body.group(4));
      assertThat(x - radius).isGreaterThan(Integer.parseInt(floor.group(1)));
      assertThat(x + radius).isLessThan(Integer.parseInt(floor.group(2)));
      assertThat(y - radius).isGreaterThan(Integer.parseInt(floor.group(3)));
      assertThat(y + radius).isLessThan(Integer.parseInt(floor.group(4)));
      bodies.add(new int[] {x, y});
    }
    assertThat(bodies).hasSize(4);
    assertIsInTrueMm(svg, bodies);
    assertIsPdf(pdf);
  }

  /** A unit is a millimetre, and each body is a circle around its start. */
  private static void assertIsInTrueMm(Path svg, List<int[]> bodies) throws Exception {
    Element root =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(svg.toFile())
            .getDocumentElement();
    String[] box = root.getAttribute("viewBox").split(" ");
    assertThat(root.getAttribute("width")).isEqualTo(box[2] + "mm");
    assertThat(root.getAttribute("height")).isEqualTo(box[3] + "mm");
    List<String> centres = new ArrayList<>();
    NodeList shapes = root.getElementsByTagName("polygon");
    for (int i = 0; i < shapes.getLength(); i++) {
      String[] points = ((Element) shapes.item(i)).getAttribute("points").split(" ");
      double x = 0;
      double y = 0;
      for (String point : points) {
        x += Double.parseDouble(point.split(",")[0]) / points.length;
        y += Double.parseDouble(point.split(",")[1]) / points.length;
      }
      centres.add(Math.round(x) + "," + Math.round(-y));
    }
    for (int[] body : bodies) {
      assertThat(centres).contains(body[0] + "," + body[1]);
    }
  }

  /** Its table names the places of its objects, and its stream has the length that it says. */
  private static void assertIsPdf(Path pdf) throws Exception {
    String text = new String(Files.readAllBytes(pdf), StandardCharsets.ISO_8859_1);
    assertThat(text).startsWith("%PDF-1.4\n").endsWith("%%EOF\n");
    int table = Integer.parseInt(text.replaceFirst("(?s).*startxref\n(\\d+)\n.*", "$1"));
    assertThat(text.substring(table)).startsWith("xref\n0 6\n");
    String[] rows = text.substring(table).split("\n");
    for (int i = 1; i <= 5; i++) {
      int at = Integer.parseInt(rows[2 + i].substring(0, 10));
      assertThat(text.substring(at)).startsWith(i + " 0 obj\n");
    }
    int length = Integer.parseInt(text.replaceFirst("(?s).*<</Length (\\d+)>>.*", "$1"));
    int begin = text.indexOf("stream\n") + "stream\n".length();
    assertThat(text.substring(begin + length)).startsWith("endstream");
  }

  @ParameterizedTest
  @CsvSource({
    "'{source: ros2, topic: \"/{robot}/pose\", type: PoseStamped, frame: lab}', the ROS frame lab",
    "'{source: json, port: 5000}', the lines of JSON"
  })
  void theOriginIsThatOfTheDeploymentsPositions(String positions, String owner) throws Exception {
    Path file = folder.resolve("other.yaml");
    Files.writeString(
        file,
        Files.readString(Path.of(SHIPPED + "crossing.yaml"))
            .replaceFirst("(?s)positions:.*?\n\n", "positions: " + positions + "\n\n"));
    Path svg = folder.resolve("other.svg");

    Cli cli = Cli.line(Apps.ALL, "deploy plan", file, "--svg", svg);
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text())
        .contains("those of " + owner + ", where y is called y")
        .doesNotContain("camera");
    assertThat(Files.readString(svg)).contains("origin 0,0 of " + owner).doesNotContain("camera");
  }

  @Test
  void aDeploymentThatCannotStartHasNoPlanAndNoFile() throws Exception {
    Path file = folder.resolve("bad.yaml");
    Files.writeString(
        file,
        Files.readString(Path.of(SHIPPED + "crossing.yaml"))
            .replace("scenario: figure7", "scenario: figure8"));
    Path svg = folder.resolve("bad.svg");

    Cli.line(Apps.ALL, "deploy plan", file, "--svg", svg).assertRefused("figure8");
    assertThat(svg).doesNotExist();
  }
}
