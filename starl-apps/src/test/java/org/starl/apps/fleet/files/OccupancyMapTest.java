package org.starl.apps.fleet.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.lifecycle.AfterTry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Lane;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Maps of map_server and Nav2. */
class OccupancyMapTest {

  private static final int FREE = 254;
  private static final int UNKNOWN = 205;

  private static final String MAP =
      """
      image: map.pgm
      resolution: 0.1
      origin: [-1.0, 2.0, 0.0]
      negate: 0
      occupied_thresh: 0.65
      free_thresh: 0.196
      """;

  private static final NavGraphs.Choice EACH_PIXEL = new NavGraphs.Choice("", -1, 100, 0);

  @TempDir private Path folder = Path.of("");

  /** Properties make folders of their own, which JUnit does not remove. */
  @AfterTry
  void removeFolder() throws IOException {
    for (File file : folder.toFile().listFiles()) {
      Files.delete(file.toPath());
    }
    Files.delete(folder);
  }

  private NavGraph read(String yaml, NavGraphs.Choice choice) {
    try {
      return NavGraphs.read(Files.writeString(folder.resolve("map.yaml"), yaml), choice);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private void write(String pgm) throws IOException {
    Files.write(folder.resolve("map.pgm"), pgm.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static String plain(int[][] pixels) {
    StringBuilder text = new StringBuilder("P2\n# a comment\n");
    text.append(pixels[0].length).append(' ').append(pixels.length).append("\n255\n");
    for (int[] row : pixels) {
      for (int pixel : row) {
        text.append(pixel).append(' ');
      }
      text.append('\n');
    }
    return text.toString();
  }

  /** Free around an occupied pixel, with a part of one pixel behind unknown ones. */
  private static final int[][] RING = {
    {FREE, FREE, FREE, UNKNOWN, FREE},
    {FREE, 0, FREE, UNKNOWN, UNKNOWN},
    {FREE, FREE, FREE, UNKNOWN, UNKNOWN}
  };

  @Test
  void freePixelsArePlacesFromTheLowerLeftCornerUp() throws IOException {
    write(plain(RING));
    NavGraph graph = read(MAP, EACH_PIXEL);
    assertThat(graph.vertices()).hasSize(8);
    assertThat(graph.vertices().get(0).name()).isEqualTo("x0y0");
    assertNear(graph.vertices().get(0).at(), new Point(-950, 2050));
    assertNear(graph.vertices().get(7).at(), new Point(-750, 2250));
    assertThat(graph.lanes()).hasSize(16);
  }

  @Test
  void occupiedPixelsAreWallsAndUnknownOnesAreNot() throws IOException {
    write(plain(RING));
    List<Point> wall = read(MAP, EACH_PIXEL).walls().all().getFirst().points();
    assertThat(read(MAP, EACH_PIXEL).walls().all()).hasSize(1);
    List<Point> expected =
        List.of(
            new Point(-900, 2100),
            new Point(-800, 2100),
            new Point(-800, 2200),
            new Point(-900, 2200));
    for (int i = 0; i < 4; i++) {
      assertNear(wall.get(i), expected.get(i));
    }
    NavGraph turned = read(MAP.replace("2.0, 0.0]", "2.0, " + StrictMath.PI / 2 + "]"), EACH_PIXEL);
    assertNear(turned.walls().all().getFirst().points().getFirst(), new Point(-1100, 2100));
  }

  @ParameterizedTest
  @ValueSource(doubles = {StrictMath.PI / 2, -1, 7})
  void theYawTurnsTheMapAboutItsCorner(double yaw) throws IOException {
    write(plain(RING));
    NavGraph straight = read(MAP, EACH_PIXEL);
    NavGraph turned = read(MAP.replace("2.0, 0.0]", "2.0, " + yaw + "]"), EACH_PIXEL);
    Point corner = new Point(-1000, 2000);
    for (int v = 0; v < 8; v++) {
      Point before = straight.vertices().get(v).at().minus(corner);
      Point after = turned.vertices().get(v).at().minus(corner);
      assertThat(after.normMm()).isCloseTo(before.normMm(), within(1e-6));
      double turn = after.angleRad() - before.angleRad() - yaw;
      assertThat(StrictMath.cos(turn)).isCloseTo(1, within(1e-9));
    }
  }

  private static void assertNear(Point is, Point expected) {
    assertThat(is.distanceMm(expected)).isLessThan(1e-6);
  }

  /** Equal pixels in each format give equal graphs. */
  @Test
  void formatsOfImagesMeanTheSame() throws IOException {
    write(plain(RING));
    NavGraph expected = read(MAP, EACH_PIXEL);
    StringBuilder narrow = new StringBuilder("P5 5 3 255\n");
    StringBuilder wide = new StringBuilder("P5 5 3 65535\n");
    BufferedImage grey = new BufferedImage(5, 3, BufferedImage.TYPE_BYTE_GRAY);
    BufferedImage colour = new BufferedImage(5, 3, BufferedImage.TYPE_INT_ARGB);
    for (int y = 0; y < 3; y++) {
      for (int x = 0; x < 5; x++) {
        int pixel = RING[y][x];
        narrow.append((char) pixel);
        wide.append((char) pixel).append((char) pixel);
        grey.getRaster().setSample(x, y, 0, pixel);
        colour.setRGB(x, y, 0xff000000 | pixel * 0x10101);
      }
    }
    write(narrow.toString());
    assertThat(read(MAP, EACH_PIXEL)).isEqualTo(expected);
    write(wide.toString());
    assertThat(read(MAP, EACH_PIXEL)).isEqualTo(expected);
    for (BufferedImage png : List.of(grey, colour)) {
      ImageIO.write(png, "png", folder.resolve("map.pgm").toFile());
      // Alpha counts as a fourth colour in trinary, so that unknown is free there.
      String mode = png == colour ? "mode: scale\n" : "";
      assertThat(read(MAP + mode, EACH_PIXEL)).isEqualTo(expected);
    }
  }

  @Test
  void transparentPixelsAreUnknownInScaleMode() throws IOException {
    BufferedImage image = new BufferedImage(4, 1, BufferedImage.TYPE_INT_ARGB);
    for (int x = 0; x < 4; x++) {
      image.setRGB(x, 0, x == 3 ? 0x80ffffff : 0xffffffff);
    }
    ImageIO.write(image, "png", folder.resolve("map.pgm").toFile());
    assertThat(read(MAP, EACH_PIXEL).vertices()).hasSize(4);
    assertThat(read(MAP + "mode: scale\n", EACH_PIXEL).vertices()).hasSize(3);
  }

  @Test
  void pixelsOfRawMapsAreOccupanciesInPercent() throws IOException {
    write(plain(new int[][] {{0, 10, 19, 100, 0, 255, 101}}));
    assertThat(read(MAP + "mode: raw\n", EACH_PIXEL).vertices()).hasSize(3);
  }

  @Test
  void negatedMapsAreFreeWhereTheyAreBlack() throws IOException {
    int[][] negative = {{255 - FREE, 255 - FREE, 255, 255 - FREE}};
    write(plain(negative));
    assertThat(read(MAP.replace("negate: 0", "negate: 1"), EACH_PIXEL).vertices()).hasSize(2);
  }

  /** Against all pixels: places and lanes keep their clearance; the graph is connected. */
  @Property(tries = 60)
  void placesAndLanesAreClear(
      @ForAll long seed,
      @ForAll @IntRange(min = 1, max = 4) int spacing,
      @ForAll @DoubleRange(min = 0, max = 250) double clearanceMm)
      throws IOException {
    folder = Files.createTempDirectory("map");
    Random random = new Random(seed);
    int[][] pixels = new int[18][23];
    for (int[] row : pixels) {
      for (int x = 0; x < row.length; x++) {
        row[x] = random.nextInt(25) == 0 ? 0 : FREE;
      }
    }
    write(plain(pixels));
    NavGraph graph;
    try {
      graph = read(MAP, new NavGraphs.Choice("", -1, spacing * 100, clearanceMm));
    } catch (BadInput none) {
      assertThat(none).hasMessageContaining("expected free cells for two places");
      return;
    }
    for (Lane lane : graph.lanes()) {
      assertThat(graph.lengthMm(lane)).isCloseTo(spacing * 100, within(1e-6));
      Point from = graph.vertices().get(lane.from()).at();
      Point way = graph.vertices().get(lane.to()).at().minus(from);
      for (int i = 0; i <= spacing; i++) {
        Point pixel = from.plus(way.times((double) i / spacing)).minus(new Point(-1000, 2000));
        assertThat(clearMm(pixels, pixel)).isGreaterThanOrEqualTo(clearanceMm - 1e-6);
      }
    }
    assertThat(NavGraphs.largestPart(graph)).isEqualTo(graph);
    assertThat(graph.vertices()).extracting(Vertex::name).doesNotHaveDuplicates();
    assertThat(graph.vertices().stream().filter(Vertex::isStation).count()).isGreaterThan(1);
  }

  /** From a place, in mm from the lower left corner, to the nearest pixel that is not free. */
  private static double clearMm(int[][] pixels, Point at) {
    double least = Double.MAX_VALUE;
    for (int y = -4; y < pixels.length + 4; y++) {
      for (int x = -4; x < pixels[0].length + 4; x++) {
        boolean isInside = x >= 0 && y >= 0 && y < pixels.length && x < pixels[0].length;
        if (isInside && pixels[y][x] == FREE) {
          continue;
        }
        double right = Math.max(0, Math.abs(at.xMm() - 100 * x - 50) - 50);
        double up = Math.max(0, Math.abs(at.yMm() - 100 * (pixels.length - 1 - y) - 50) - 50);
        least = Math.min(least, StrictMath.sqrt(right * right + up * up));
      }
    }
    return least;
  }

  /** Robots that stand on all stations and chargers leave a way between each two of them. */
  @Property(tries = 40)
  void stationsAndChargersBlockNoWay(@ForAll long seed) throws IOException {
    folder = Files.createTempDirectory("map");
    Random random = new Random(seed);
    int[][] pixels = new int[9][12];
    for (int[] row : pixels) {
      for (int x = 0; x < row.length; x++) {
        row[x] = random.nextInt(8) == 0 ? 0 : FREE;
      }
    }
    write(plain(pixels));
    NavGraph graph = read(MAP, EACH_PIXEL);
    List<List<Integer>> next = new ArrayList<>();
    graph.vertices().forEach(v -> next.add(new ArrayList<>()));
    graph.lanes().forEach(lane -> next.get(lane.from()).add(lane.to()));
    TreeSet<Integer> passable = new TreeSet<>();
    for (int v = 0; v < graph.vertices().size(); v++) {
      Vertex vertex = graph.vertices().get(v);
      if (!vertex.isStation() && !vertex.isCharger()) {
        passable.add(v);
      }
    }
    for (int v = 0; v < next.size(); v++) {
      assertThat(next.get(v)).hasSizeLessThanOrEqualTo(graph.vertices().get(v).isCharger() ? 1 : 4);
    }
    if (passable.isEmpty()) {
      return; // a part so small that each place is a station
    }
    TreeSet<Integer> reached = new TreeSet<>();
    List<Integer> open = new ArrayList<>(List.of(passable.first()));
    while (!open.isEmpty()) {
      int v = open.remove(open.size() - 1);
      if (reached.add(v) && passable.contains(v)) {
        open.addAll(next.get(v));
      }
    }
    assertThat(reached).hasSize(graph.vertices().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          0.1 | 0 | :2: resolution: '0': expected a number from 1.0E-4 to 100.0
          0.1 | 0.3 | :2: resolution: '0.3': expected at most the spacing of places, 0.1 m
          resolution: | size: | :1: has no 'resolution:'; expected metres per pixel
          [-1.0, 2.0, 0.0] | [-1.0, 2.0] | :3: origin: a list of 2: expected [X, Y, YAW]
          [-1.0, 2.0, 0.0] | [-1.0, 2.0, 0.0, 1.0] | :3: origin: a list of 4: expected [X, Y, YAW]
          [-1.0, 2.0, 0.0] | [-1.0, 2.0, north] | :3: origin[2]: 'north': expected a number from -100.0 to 100.0
          negate: 0 | negate: 2 | :4: negate: '2': expected one of 0, 1, false, true
          0.65 | 0.1 | :5: occupied_thresh: '0.1': expected at least free_thresh, 0.196
          0.196 | 19.6 | :6: free_thresh: '19.6': expected a number from 0.0 to 1.0
          free_thresh: | free_tresh: | :1: has no 'free_thresh:'; expected a number from 0 to 1
          negate: 0 | mode: grey | :4: mode: 'grey': expected one of trinary, scale, raw
          """)
  void badLinesAreTold(String good, String bad, String line) throws IOException {
    write(plain(RING));
    assertThatThrownBy(() -> read(MAP.replace(good, bad), EACH_PIXEL))
        .isInstanceOf(BadInput.class)
        .hasMessage(folder.resolve("map.yaml") + line);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          P6 1 1 255 x | : is no such image; expected an image, PGM (P2 or P5) or PNG
          P5 2 2 255 xxx | : ends early: expected 4 bytes of pixels after the header
          P5 2 two 255 xxxx | :1: 't': expected a whole number from 0 to 2147483647
          P2 2 1 255 9 | :1: '': expected a whole number from 0 to 255
          P2 2 1 255 9  9 | :1: ' ': expected a whole number from 0 to 255
          P2 2 1 255 9 9 9 | :1: '9': expected only 2 x 1 values
          P5 2 1 255x99 | :1: 'x': expected white space
          P55 2 1 255 99 | :1: '5': expected white space
          P2 2 1 255 9 256 | :1: '256': expected a whole number from 0 to 255
          P2 2 1 0 0 0 | :1: '0': expected a largest value from 1 to 65535
          P5 0 1 255 x | : 0 x 1: expected 1 to 16000000 pixels
          P5 99999 99999 255 x | : 99999 x 99999: expected 1 to 16000000 pixels
          """)
  void badImagesAreTold(String image, String line) throws IOException {
    write(image);
    assertThatThrownBy(() -> read(MAP, EACH_PIXEL))
        .isInstanceOf(BadInput.class)
        .hasMessage(folder.resolve("map.pgm") + line);
  }

  @Test
  void aDamagedPngIsRefused() throws IOException {
    BufferedImage image = new BufferedImage(5, 3, BufferedImage.TYPE_BYTE_GRAY);
    for (int i = 0; i < 15; i++) {
      image.getRaster().setSample(i % 5, i / 5, 0, RING[i / 5][i % 5]);
    }
    Path file = folder.resolve("map.pgm");
    ImageIO.write(image, "png", file.toFile());
    byte[] good = Files.readAllBytes(file);
    for (int i = 0; i < good.length; i++) {
      byte[] bad = good.clone();
      bad[i] ^= 4;
      Files.write(file, bad);
      assertThatThrownBy(() -> read(MAP, EACH_PIXEL)).as("byte %d", i).isInstanceOf(BadInput.class);
      Files.write(file, Arrays.copyOf(good, i));
      assertThatThrownBy(() -> read(MAP, EACH_PIXEL))
          .as("first %d", i)
          .isInstanceOf(BadInput.class);
    }
  }

  @Test
  void otherImagesAreTold() throws IOException {
    Path image = folder.resolve("map.pgm");
    assertThatThrownBy(() -> read(MAP, EACH_PIXEL))
        .isInstanceOf(BadInput.class)
        .hasMessage(image + ": no such file; expected an image, PGM (P2 or P5) or PNG");
    write("\u0089PNG\r\n\u001a\nbroken");
    assertThatThrownBy(() -> read(MAP, EACH_PIXEL))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith(image + ": is a broken PNG image");
    write(plain(new int[][] {{0, FREE, 0}}));
    assertThatThrownBy(() -> read(MAP, EACH_PIXEL))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("map.yaml: expected free cells for two places 100.0 mm apart");
  }
}
