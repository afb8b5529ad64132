package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.request.TraceFile;
import org.starl.random.Rng;
import org.starl.sim.SimResult;
import org.starl.sim.TraceRecorder;
import org.starl.sim.record.BoundingBox;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Viewport;
import org.starl.sim.replay.Cursor;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;

/**
 * Of every app and every primitive: a trace is run again to the same bytes, watched or not; and any
 * moment of it looks the same, whichever way one comes there.
 */
@Tag("long")
class EveryDemoReplaysTest {

  private static final int LOOKS = 6;
  private static final int WIDTH_PX = 460;
  private static final int HEIGHT_PX = 340;

  @TempDir private Path folder;

  static Stream<List<String>> runs() {
    List<List<String>> runs = new ArrayList<>();
    for (Demo demo : Apps.ALL.all()) {
      runs.add(
          demo.name().equals("paths")
              ? List.of(demo.name(), "--seed", "11", "--robots", "3")
              : List.of(demo.name(), "--seed", "11"));
    }
    runs.add(List.of("intersection", "--seed", "5", "--set", "arrivals=20/min", "--for", "40s"));
    runs.add(List.of("intersection", "--seed", "7", "--set", "scenario=figure7", "--chaos"));
    runs.add(List.of("intersection", "--seed", "3", "--chaos"));
    runs.add(List.of("mutex", "--seed", "2", "--robots", "4", "--chaos", "--loss", "0.2"));
    runs.add(List.of("hello", "--seed", "1", "--fault", "drift(bot1,200ppm)", "--robots", "6"));
    return runs.stream();
  }

  @ParameterizedTest
  @MethodSource("runs")
  void itReplaysAndLooksTheSameFromEverywhere(List<String> words) throws IOException {
    Path file = folder.resolve("a.trace");
    List<String> run = new ArrayList<>(List.of("run"));
    run.addAll(words);
    run.addAll(List.of("--trace", file.toString(), "--png", folder.resolve("a.png").toString()));
    assertThat(Cli.run(run.toArray(String[]::new)).status()).isZero();

    Cli replayed = Cli.run("replay", file.toString(), "--headless");
    long lines;
    try (Stream<String> all = Files.lines(file)) {
      lines = all.count();
    }
    assertThat(replayed.out()).contains("equal: " + lines + " lines");
    assertThat(replayed.status()).isZero();

    TraceFile trace = TraceFile.open(file.toString(), Apps.ALL);
    assertThat(watched(trace)).as("watched").isEqualTo(Files.readAllBytes(file));
    Plan plan = trace.plan();
    Recording recording = new Recording(plan.obstacles(), plan.layer());
    SimResult result = trace.show(List.of(recording));
    assertThat(result.spec().violations()).isEmpty();
    looksTheSame(words, trace, recording);
  }

  private static byte[] watched(TraceFile trace) throws IOException {
    Plan plan = trace.plan();
    Recording recording = new Recording(plan.obstacles(), plan.layer());
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try (TraceRecorder recorder = new TraceRecorder(out);
        LiveRun live = new LiveRun(plan.simulation().observer(recorder), recording)) {
      live.runUntil(Long.MAX_VALUE);
      live.start();
      while (!live.isOver()) {
        Thread.onSpinWait();
      }
    }
    return out.toByteArray();
  }

  /** Its cursor has been at the end, and painted on its way. */
  private static void looksTheSame(List<String> words, TraceFile trace, Recording recording) {
    Cursor cursor = new Cursor(recording);
    cursor.seek(recording.endNs());
    Rng rng = new Rng(3);
    for (int i = 0; i < LOOKS; i++) {
      long timeNs = rng.nextLong(0, recording.endNs());
      cursor.seek(timeNs);
      Scene scene = new Scene(recording.obstacles());
      Layer layer = trace.plan().layer();
      for (int event = 0; event < cursor.index(); event++) {
        scene.observe(recording.event(event));
        layer.observe(recording.event(event));
      }
      scene.advance(timeNs);
      assertThat(described(cursor.scene(), cursor.layer()))
          .as("%s at %d ns", words, timeNs)
          .isEqualTo(described(scene, layer));
      assertThat(Arrays.equals(pixels(cursor.scene(), cursor.layer()), pixels(scene, layer)))
          .as("%s at %d ns: equal pictures", words, timeNs)
          .isTrue();
    }
  }

  private static List<String> described(Scene scene, Layer layer) {
    List<String> lines = new ArrayList<>();
    scene.robots().forEach(robot -> lines.add(robot + ": " + layer.describe(robot, scene)));
    lines.add(layer.corners() + ", interest " + layer.interest(scene));
    return lines;
  }

  private static int[] pixels(Scene scene, Layer layer) {
    BufferedImage image = new BufferedImage(WIDTH_PX, HEIGHT_PX, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    Viewport viewport = Viewport.fit(BoundingBox.of(scene, layer), WIDTH_PX, HEIGHT_PX, 10);
    new Painter().paint(page, scene, layer, viewport, Look.FILE);
    page.dispose();
    return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
  }
}
