package org.starl.apps.fleet.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.starl.apps.fleet.logic.NavGraph;
import org.starl.apps.fleet.logic.NavGraph.Vertex;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Broken files are refused in one line with the name of a file; no other exception comes out. */
class FilesFuzzTest {

  private static final String MAP =
      "image: map.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
          + "free_thresh: 0.196\nmode: scale\n";

  private static final String PGM = "P2 4 3 255\n254 254 254 254 0 254 205 254 254 254 254 254\n";
  private static final List<String> PIECES =
      List.of("[", "]", "{", "}", ":", ",", "-", "0", "9", "1e9", "\n", " ", "\"", "x", "&a", "P5");

  @Property(tries = 400)
  void brokenBuildings(@ForAll long seed) throws IOException {
    assertRead(seed, "b.yaml", BuildingMapTest.GOOD, NavGraphs::read);
  }

  @Property(tries = 400)
  void brokenMaps(@ForAll long seed) throws IOException {
    assertRead(
        seed,
        "map.yaml",
        MAP,
        file -> {
          Files.writeString(file.resolveSibling("map.pgm"), PGM);
          NavGraphs.read(file);
        });
  }

  @Property(tries = 400)
  void brokenImages(@ForAll long seed) throws IOException {
    String good = seed % 2 == 0 ? PGM : "P5 4 3 127\n~~~~!~!~~~~~";
    assertRead(
        seed,
        "map.pgm",
        good,
        file -> NavGraphs.read(Files.writeString(file.resolveSibling("map.yaml"), MAP)));
  }

  @Property(tries = 400)
  void brokenDeliveries(@ForAll long seed) throws IOException {
    NavGraph graph =
        new NavGraph(
            List.of(
                new Vertex("a", new Point(0, 0), false, true, false),
                new Vertex("b", new Point(0, 0), false, true, false)),
            List.of());
    String good = seed % 2 == 0 ? "90s a b # one\n2min b a\n" : "2\n0 0 1 0 0\n7 1 0\n";
    assertRead(seed, "d.task", good, file -> Deliveries.read(file, graph, 1000));
  }

  private interface Reader {
    void read(Path file) throws IOException;
  }

  private static void assertRead(long seed, String name, String good, Reader reader)
      throws IOException {
    Random random = new Random(seed);
    StringBuilder text = new StringBuilder(good);
    for (int i = random.nextInt(4); i >= 0; i--) {
      int at = random.nextInt(text.length());
      int end = Math.min(text.length(), at + random.nextInt(4));
      text.replace(at, end, PIECES.get(random.nextInt(PIECES.size())));
    }
    Path folder = Files.createTempDirectory("fuzz");
    Path file = folder.resolve(name);
    Files.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    try {
      reader.read(file);
    } catch (BadInput error) {
      assertThat(error.getMessage()).startsWith(folder.toString()).doesNotContain("\n");
    }
    for (File made : folder.toFile().listFiles()) {
      Files.delete(made.toPath());
    }
    Files.delete(folder);
  }
}
