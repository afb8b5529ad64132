package org.starl.sim.view.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.InflaterInputStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.SimulationPlan;
import org.starl.sim.TraceRecorder;
import org.starl.sim.check.RunArtifacts;

/** The files beside a trace, as a failing test asks for them. */
class TraceArtifactsTest {

  @TempDir Path folder;

  private static Simulation.Builder simulation() {
    SimSettings settings = SimSettings.builder().duration(Duration.ofSeconds(3)).build();
    return Simulation.builder().settings(settings).seed(3).robots(2, Drive::new);
  }

  private static final class Drive extends LogicThread {
    Drive(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      var start = gvh.gps.pose();
      gvh.plat.moat.doMove(new ItemPosition("goal", start.xMm() + 1000, start.yMm()));
      sleep(2000);
      return List.of();
    }
  }

  private Path trace() throws IOException {
    Path trace = folder.resolve("seed-3.trace");
    try (TraceRecorder recorder = new TraceRecorder(Files.newOutputStream(trace))) {
      simulation().observer(recorder).build().run();
    }
    return trace;
  }

  private static List<Path> written(Path trace) throws IOException {
    SimulationPlan plan = simulation().build().plan();
    return RunArtifacts.installed()
        .orElseThrow()
        .write(trace, GlobalVarHolder.VOCABULARY, plan, "bot0 fell over");
  }

  @Test
  void aPictureAndAPageAreWrittenBesideTheTrace() throws IOException {
    Path picture = folder.resolve("seed-3.png");
    Path page = folder.resolve("seed-3.html");

    assertThat(written(trace())).containsExactly(picture, page);
    assertThat(ImageIO.read(picture.toFile()).getWidth()).isEqualTo(1420);
    assertThat(page).content().startsWith("<!DOCTYPE html>");
  }

  @Test
  void aTruncatedTraceIsShownUpToItsError() throws IOException {
    Path trace = trace();
    List<String> lines = Files.readAllLines(trace);
    Files.write(trace, lines.subList(0, lines.size() / 2));

    assertThat(written(trace)).allMatch(Files::exists).isNotEmpty();
    Matcher packed =
        Pattern.compile("<script id=\"run\" [^>]*>([^<]*)")
            .matcher(Files.readString(folder.resolve("seed-3.html")));
    assertThat(packed.find()).isTrue();
    byte[] run = Base64.getDecoder().decode(packed.group(1));
    assertThat(new InflaterInputStream(new ByteArrayInputStream(run)))
        .asString(StandardCharsets.UTF_8)
        .contains("\"kind\":\"FAILED\"")
        .contains("\"headline\":\"bot0 fell over\"");
  }
}
