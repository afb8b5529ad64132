package org.starl.apps.lightpaint;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.SortedMap;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.sim.SimResult;

/** Strokes shorter than the tolerance, with short legs, or near themselves: all are painted. */
class RealDrawingsTest {

  private static final LightPaintDemo DEMO = new LightPaintDemo();

  private static void assertPainted(Path folder, String path, int robots) throws IOException {
    String svg =
        "<svg xmlns='http://www.w3.org/2000/svg' width='90' height='90' fill='none' stroke='red'>"
            + "<path d='%s'/></svg>";
    Path file = Files.writeString(folder.resolve("drawing.svg"), svg.formatted(path));
    for (long seed = 1; seed <= 2; seed++) {
      SortedMap<String, String> parameters = DEMO.defaults();
      parameters.put("drawing", file.toString());
      Request request = new Request(seed, OptionalInt.of(robots), parameters);
      Plan plan = DEMO.plan(request, DEMO.defaultSettings(request).build());
      SimResult result = plan.simulation().name("lightpaint").seed(seed).build().run();
      assertThat(result.spec().violations()).as("%s, seed %s", path, seed).isEmpty();
      assertThat(result.unfinished()).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "M20 20h.1",
        "M20 20h.3",
        "M20 20h.7",
        "M20 20v1.5",
        "M20 20v.9 M40 20h40",
        // Dots, a ring, and a square, each smaller than a robot's tolerance.
        "M20 20a.3 .3 0 0 1 .6 0a.3 .3 0 0 1 -.6 0",
        "M20 20a.9 .9 0 0 1 1.8 0a.9 .9 0 0 1 -1.8 0",
        "M20 20a2 2 0 0 1 4 0a2 2 0 0 1 -4 0",
        "M20 20h2v2h-2z",
        // Stairs, and letters with serifs.
        "M20 20h1v1h1v1h1v1h1v1h1v1h1",
        "M20 20h2v1h-2z M20 30h1.4v8h1v.8h-3.4v-.8h1v-7.2h-1z",
        "M20 50v-14h2l6 11v-11h2v14h-2l-6 -11v11z",
        "M30 30a5 5 0 1 0 5 5h-8 M60 30q-9 0 -9 6t9 6t9 6t-9 6",
        "M30 30h9a4.5 4.5 0 1 0 -1.7 3.6",
        "M30 30a4 4 0 1 1 4 4a5 5 0 1 0 0 .1",
        "M30 40q10 -2 10 -9a5 5 0 1 0 -9 3q4 3 8 -1",
        // Sharp corners.
        "M20 20l30 3l-30 3l30 3l-30 3",
        "M20 20h40h-40",
      })
  void shortStrokesAndGlyphsArePainted(String path, @TempDir Path folder) throws IOException {
    assertPainted(folder, path, 2);
  }

  @ParameterizedTest
  @CsvSource({"2.6, 25", "7, 35"})
  void aSpiralIsPaintedOnce(double pitch, double radius, @TempDir Path folder) throws IOException {
    StringBuilder path = new StringBuilder("M45 45");
    for (double turns = 0; turns * pitch < radius; turns += 0.05 / (1 + 0.2 * turns)) {
      double x = 45 + pitch * turns * Math.cos(2 * Math.PI * turns);
      double y = 45 + pitch * turns * Math.sin(2 * Math.PI * turns);
      path.append(String.format(Locale.ROOT, "L%.2f %.2f ", x, y));
    }
    assertPainted(folder, path.toString(), 3);
  }
}
