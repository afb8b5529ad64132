package org.starl.apps.lightpaint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.SortedMap;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.LightColour;
import org.starl.LightControl;
import org.starl.apps.Input;
import org.starl.apps.Plan;
import org.starl.apps.Product;
import org.starl.apps.Request;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Location;
import org.starl.apps.lightpaint.logic.PaintFact;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.SimObserver;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.time.Time;
import org.starl.trace.TraceEvent;

/** Whole runs of light painting. */
class LightPaintTest {

  private static final LightPaintDemo DEMO = new LightPaintDemo();

  /** Two lines that cross, and a third beside them. */
  private static final String SMALL =
      "WAY,0,0,255,0-A_4\nWAY,900,900,255,0-B_4\nWAY,0,900,65280,1-A_4\nWAY,900,0,65280,1-B_4\n"
          + "WAY,1500,0,16711680,2-A_4\nWAY,1500,800,16711680,2-B_4\n";

  private static final int STROKES = 5;

  private static Plan plan(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    SortedMap<String, String> all = DEMO.defaults();
    all.putAll(parameters);
    Request request = new Request(seed, OptionalInt.of(robots), all);
    SimSettings.Builder builder = DEMO.defaultSettings(request);
    settings.forEach(builder::set);
    Plan plan = DEMO.plan(request, builder.build());
    plan.simulation().name("lightpaint").seed(seed);
    return plan;
  }

  private static SimResult run(
      long seed, int robots, Map<String, String> parameters, Map<String, String> settings) {
    SimResult result = plan(seed, robots, parameters, settings).simulation().build().run();
    String which = "seed " + seed + ", " + robots + " robots, " + parameters + " " + settings;
    assertThat(result.spec().violations()).as(which).isEmpty();
    assertThat(result.unfinished()).as(which).isEmpty();
    return result;
  }

  private static Map<String, String> small(Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("small.wpt"), SMALL);
    return Map.of("drawing", file.toString());
  }

  /** All robots report that no stroke is left, and together they painted each stroke once. */
  private static void assertAllPainted(SimResult result, int strokes) {
    int painted = 0;
    for (List<Object> said : result.results().values()) {
      painted += (Integer) said.get(0);
      assertThat(said.get(1)).isEqualTo(0);
    }
    assertThat(painted).isEqualTo(strokes);
  }

  @Test
  void theHouseIsPaintedAndItsSvgCanBeRead() throws IOException {
    Plan plan = plan(1, 4, Map.of(), Map.of());
    SimResult result = plan.simulation().build().run();
    assertThat(result.spec().violations()).isEmpty();
    assertAllPainted(result, 20);
    assertThat(plan.story().lines()).hasSize(5).last().asString().contains("in 20 strokes");
    for (Product product : plan.story().products()) {
      ByteArrayOutputStream out = new ByteArrayOutputStream();
      product.content().write(out);
      if (product.ending().equals(".png")) {
        assertThat(ImageIO.read(new ByteArrayInputStream(out.toByteArray())).getWidth())
            .isGreaterThan(1000);
      } else {
        // The drawing, pale, and what was painted: the same lines again.
        List<Line> lines =
            SvgDrawing.read(
                    "painted.svg", out.toByteArray(), new SvgDrawing.Reading(1, false, 1, false))
                .lines();
        double mm = lines.stream().mapToDouble(line -> line.path().lengthMm()).sum();
        assertThat(mm).isBetween(2 * 15_200.0, 2 * 15_600.0);
      }
    }
  }

  @Test
  void theLightShowsTheInkOfTheStrokeAndWhiteForBlack(@TempDir Path folder) throws IOException {
    String lines =
        "WAY,0,0,255,0-A_4\nWAY,900,0,255,0-B_4\nWAY,0,900,0,1-A_4\nWAY,900,900,0,1-B_4\n";
    Path file = Files.writeString(folder.resolve("lines.wpt"), lines);
    Plan plan = plan(1, 1, Map.of("drawing", file.toString()), Map.of());
    List<String> colours = new ArrayList<>();
    plan.simulation()
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                if (event instanceof TraceEvent.Variable variable
                    && variable.of(LightControl.COLOUR) instanceof LightColour colour) {
                  colours.add(colour.toString());
                }
              }
            });
    assertThat(plan.simulation().build().run().spec().violations()).isEmpty();
    assertThat(colours).containsExactlyInAnyOrder("off", "#0000ff", "off", "#ffffff", "off");
  }

  @ParameterizedTest
  @CsvSource({"1, 0", "2, 0.2", "3, 0.2", "6, 0.1"})
  void anyNumberOfPaintersFinishesEvenWithLoss(int robots, String loss, @TempDir Path folder)
      throws IOException {
    assertAllPainted(run(robots, robots, small(folder), Map.of("messageLoss", loss)), STROKES);
  }

  @Test
  void paintersWithTheDefaultLimitsOfADeploymentPaintEverything(@TempDir Path folder)
      throws IOException {
    Map<String, String> limits = Map.of("reaction", "200ms", "speedError", "0.1");
    assertAllPainted(run(7, 4, small(folder), limits), STROKES);
  }

  @ParameterizedTest
  @ValueSource(strings = {"moving", "spatial"})
  void everythingIsPaintedUnderChaos(String envelope, @TempDir Path folder) throws IOException {
    for (long seed = 1; seed <= 3; seed++) {
      assertAllPainted(run(seed, 4, small(folder), Map.of("chaos", envelope)), STROKES);
    }
  }

  @Test
  void aPainterThatCrashesDuringAStrokeContinuesWhereItStopped(@TempDir Path folder)
      throws IOException {
    for (int atMs = 6_000; atMs <= 11_000; atMs += 2_500) {
      String crash = "crash(bot0,at=" + atMs + "ms,restart=7s)";
      SimResult result = run(atMs, 2, small(folder), Map.of("faults", crash));
      assertAllPainted(result, STROKES);
    }
  }

  /**
   * It is decided that a painter has the stroke for which it asked before it crashed. When it comes
   * back, another one works near to that stroke.
   */
  @Test
  void aPainterKeepsTheStrokeForWhichItAskedBeforeACrash() {
    String faults =
        String.join(
            ";",
            "partition(any,at=124ms,until=6035ms)",
            "crash(any,at=7052ms,until=8337ms)",
            "crash(any,at=22963ms,until=26156ms)",
            "partition(any,at=26680ms,until=36212ms)",
            "crash(half,lose=some,at=36108ms,until=37041ms)",
            "crash(half,lose=some,at=39477ms,until=41098ms)",
            "partition(any,at=49020ms,until=50548ms)",
            "partition(all>any,at=21817ms,until=39184ms)",
            "partition(any>all,at=35374ms,until=49548ms)",
            "partition(all>any,at=8654ms,until=30070ms)");
    SimResult result = run(58, 3, Map.of(), Map.of("faults", faults));
    assertAllPainted(result, 20);
  }

  @Test
  void aPainterThatCrashesAfterItsLastStrokeDoesNotDriveThereAgain(@TempDir Path folder)
      throws IOException {
    String line = "WAY,0,0,255,0-A_4\nWAY,900,0,255,0-B_4\n";
    Path file = Files.writeString(folder.resolve("line.wpt"), line);
    Map<String, String> drawing = Map.of("drawing", file.toString());
    long parksMs = times(drawing, Map.of(), Location.PARK).get(0);
    String crash = "crash(bot0,at=" + (parksMs + 500) + "ms,restart=2s)";
    assertThat(times(drawing, Map.of("faults", crash), Location.PARK)).hasSize(2);
    assertThat(times(drawing, Map.of("faults", crash), Location.GO)).hasSize(1);
  }

  /** When the only painter came to a location, in ms. */
  private static List<Long> times(
      Map<String, String> parameters, Map<String, String> settings, Location location) {
    List<Long> times = new ArrayList<>();
    Plan plan = plan(1, 1, parameters, settings);
    plan.simulation()
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                if (event instanceof TraceEvent.Variable variable
                    && variable.of(PaintFact.LOCATION) == location) {
                  times.add(variable.timeNs() / Time.NS_PER_MS);
                }
              }
            });
    assertThat(plan.simulation().build().run().spec().violations()).isEmpty();
    return times;
  }

  @Test
  void ifAPainterNeverRestartsTheOthersPaintWhatItDoesNotBlock() {
    SimResult result = run(1, 4, Map.of(), Map.of("faults", "crash(bot1,at=20s)"));
    int painted = 0;
    for (List<Object> said : result.results().values()) {
      painted += (Integer) said.get(0);
    }
    assertThat(result.results()).hasSize(3).doesNotContainKey(new RobotId("bot1"));
    assertThat(painted).isBetween(10, 20);
  }

  /**
   * A painter that gave way is at home before its storage has flushed that it gives its tube back.
   */
  @Test
  void paintersComeBackAlsoWithSlowStorage(@TempDir Path folder) throws IOException {
    for (long seed = 1; seed <= 3; seed++) {
      assertAllPainted(run(seed, 4, small(folder), Map.of("stableDelay", "150ms")), STROKES);
    }
  }

  @Test
  void everythingIsPaintedWithNoisyPositionsAndStartsOnTheDrawing(@TempDir Path folder)
      throws IOException {
    Path starts =
        Files.writeString(
            folder.resolve("starts.wpt"), "WAY,450,450,0,bot0\nWAY,1500,100,90,bot1\n");
    Map<String, String> parameters =
        Map.of("drawing", small(folder).get("drawing"), "starts", starts.toString());
    assertAllPainted(run(1, 2, parameters, Map.of("positionNoise", "10mm")), STROKES);
  }

  @Test
  void everyDrawingOfTheOriginalHasARun() {
    Path data = OriginalDrawings.folder().resolve("../..");
    assertThat(DEMO.inputs(data))
        .extracting(Input::name)
        .containsAll(OriginalDrawings.NAMES)
        .hasSize(OriginalDrawings.NAMES.size() + 1);
    assertThat(DEMO.inputs(data)).allMatch(input -> Files.isRegularFile(input.path()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "scale; 0mm; scale: '0mm': expected",
        "flatness; wide; flatness: ",
        "stroke; 1mm; stroke: '1mm': expected",
        "drawing; none.svg; none.svg: no such file; expected a drawing",
        "starts; none.wpt; none.wpt: no such file"
      })
  void theErrorNamesTheBadParameter(String key, String value, String expected) {
    assertThatThrownBy(() -> plan(1, 4, Map.of(key, value), Map.of()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining(expected);
  }

  @Test
  void tooFewOrTooNearStartsAreRefused(@TempDir Path folder) throws IOException {
    Path starts = Files.writeString(folder.resolve("starts.wpt"), "WAY,0,0,0,a\nWAY,100,0,0,b\n");
    Map<String, String> parameters = Map.of("starts", starts.toString());
    assertThatThrownBy(() -> plan(1, 2, parameters, Map.of()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("a and b are 100 mm apart: expected at least");
    assertThatThrownBy(() -> plan(1, 3, parameters, Map.of()))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("2 starts: expected one for each of 3 painters");
  }

  @Test
  @Tag("long")
  void sixteenPaintersNeedLessTimeThanFour() {
    long fourNs = 0;
    long sixteenNs = 0;
    for (long seed = 1; seed <= 3; seed++) {
      fourNs += run(seed, 4, Map.of(), Map.of()).endNs();
      sixteenNs += run(seed, 16, Map.of(), Map.of()).endNs();
    }
    assertThat(sixteenNs).isLessThan(fourNs);
  }

  @Test
  void sixteenPaintersHaveHomes() {
    Plan crowded = plan(1, 16, Map.of(), Map.of());
    assertThat(crowded.layer().corners()).allMatch(Point::isFinite);
  }

  @Test
  void morePaintersThanTheTubesAllowAreRefused() {
    assertThatThrownBy(() -> plan(1, 201, Map.of(), Map.of()))
        .isInstanceOf(BadInput.class)
        .hasMessage("robots: 201: expected 1 to 200 painters");
  }
}
