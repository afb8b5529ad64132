package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.cli.Cli;
import org.starl.cli.command.ExitStatus;
import org.starl.sim.kernel.CarrierKind;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceReader;

/** {@code starl run} and {@code record}, where all is well. */
class RunTest {

  private static final int FEWEST_COLOURS = 20;

  @TempDir private Path folder;

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  private byte[] trace(String name, String... args) throws IOException {
    List<String> all = new ArrayList<>(List.of("run"));
    all.addAll(List.of(args));
    all.addAll(List.of("--png", file("a.png"), "--trace", file(name)));
    Cli cli = Cli.run(all.toArray(String[]::new));
    assertThat(cli.status()).as("%s", cli).isZero();
    return Files.readAllBytes(folder.resolve(name));
  }

  private static void assertIsAPicture(Path png) throws IOException {
    BufferedImage picture = ImageIO.read(png.toFile());
    Set<Integer> colours = new HashSet<>();
    for (int x = 0; x < picture.getWidth(); x++) {
      for (int y = 0; y < picture.getHeight(); y++) {
        colours.add(picture.getRGB(x, y));
      }
    }
    assertThat(colours).hasSizeGreaterThan(FEWEST_COLOURS);
  }

  @Test
  void explainPrintsTheSentenceOfEachSpecification() {
    Cli cli = Cli.run("run", "hello", "--seed", "1", "--explain");
    assertThat(cli.out())
        .filteredOn(line -> line.startsWith("  "))
        .hasSize(5)
        .allMatch(line -> line.matches("  [\\w.]+: [A-Z].*\\. \\([0-9]+ checks\\)"));
    assertThat(Cli.run("run", "hello", "--seed", "1").text()).doesNotContain("checks)");
  }

  @Test
  void aRunWithoutSpecificationsSaysThatNoneWasChecked() {
    Cli cli = Cli.run("run", "hello", "--seed", "1", "--specs", "off", "--png", file("a.png"));
    assertThat(cli.status()).isZero();
    assertThat(cli.out()).contains("specifications: not checked (--specs off)");
    assertThat(cli.text()).doesNotContain("held");
  }

  @Test
  void aRunOfSafetyNamesTheSpecificationsThatItLeavesOut() {
    Cli cli =
        Cli.run("run", "intersection", "--seed", "7", "--specs", "safety", "--png", file("a.png"));
    assertThat(cli.status()).isZero();
    assertThat(cli.out())
        .contains(
            "not checked (--specs safety): intersection.traffic_progress motion.arrives motion.told"
                + " mutex.NonInterference mutex.Served")
        .anyMatch(line ->
            line.matches("[0-9]+ specifications held, .* intersection\\.traffic_safety .*"));
    assertThat(cli.text()).doesNotContain("never checked");
  }

  @Test
  void listOfAnAppHasTheSentenceOfEachSpecification() {
    Cli cli = Cli.run("list", "hello");
    assertThat(cli.out().get(0)).startsWith("app hello: ");
    assertThat(cli.out())
        .filteredOn(line -> line.startsWith("  lemma "))
        .hasSize(5)
        .allMatch(line -> line.matches("  lemma [\\w.]+: [A-Z].*\\."));
    Cli wrong = Cli.run("list", "helo");
    assertThat(wrong.status()).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(wrong.err()).singleElement().asString().contains("'helo'", "hello");
  }

  @Test
  void aRunIsWrittenAsTheories() throws IOException {
    Path pvs = folder.resolve("run.pvs");
    Cli cli =
        Cli.run(
            "run intersection --seed 7 --set car=paper --png %s --pvs %s"
                .formatted(file("a.png"), pvs)
                .split(" "));
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(Files.readString(pvs))
        .contains("run_mutex_crossing: THEORY")
        .contains("IMPORTING Registration_decls[PIDS]")
        .contains("reached_20: LEMMA reachable(s_20)");
  }

  @Test
  void figure7HasStoryTraceTableAndPicture() throws IOException {
    Path trace = folder.resolve("a.trace");
    Path csv = folder.resolve("a.csv");
    Path png = folder.resolve("deep/er/a.png");
    Cli cli =
        Cli.run(
            "run intersection --seed 7 --set scenario=figure7 --set car=paper --trace %s --csv %s --png %s"
                .formatted(trace, csv, png)
                .split(" "));
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out().get(0)).isEqualTo("intersection, seed 7");
    for (int car = 0; car < 4; car++) {
      assertThat(cli.out().get(1 + car))
          .startsWith("bot" + car + " (")
          .contains(" came at ", "was registered at ", "waited ", "left the floor at ");
    }
    assertThat(cli.out().get(5)).startsWith("4 of 4 robots finished in ");
    assertThat(cli.out().get(6))
        .contains("specifications held")
        .contains("intersection.traffic_safety");
    assertThat(cli.out().get(7)).isEqualTo("picture: " + png);
    assertIsAPicture(png);
    assertReadsToItsEnd(trace);
    assertIsATable(csv);
    try (var left = Files.list(folder)) {
      assertThat(left).containsExactlyInAnyOrder(trace, csv, folder.resolve("deep"));
    }
  }

  private static void assertReadsToItsEnd(Path trace) throws IOException {
    try (InputStream in = Files.newInputStream(trace);
        TraceReader reader = new TraceReader(trace.toString(), in, CrossingFact.FIGURE_4)) {
      assertThat(reader.header().scenario()).isEqualTo("intersection");
      assertThat(reader.header().scenarioSeed()).isEqualTo(7);
      assertThat(reader.header().robots()).hasSize(4);
      assertThat(reader.header().settings())
          .containsEntry("scenario", "figure7")
          .containsEntry("debris", "1")
          .containsEntry("messageDelay", "uniform(80ms,120ms)");
      int left = 0;
      for (TraceEvent event = reader.next(); event != null; event = reader.next()) {
        left += event instanceof TraceEvent.Left ? 1 : 0;
      }
      assertThat(left).isEqualTo(4);
      assertThat(reader.end()).isNotNull();
    }
  }

  private static void assertIsATable(Path csv) throws IOException {
    List<String> lines = Files.readAllLines(csv);
    assertThat(lines.get(0))
        .isEqualTo("time_s,robot,event,x_mm,y_mm,heading_rad,mm_per_s,rad_per_s");
    double lastTimeS = 0;
    for (String line : lines.subList(1, lines.size())) {
      String[] cells = line.split(",", -1);
      assertThat(cells).as(line).hasSize(8);
      assertThat(cells[0]).as(line).matches("[0-9]+(\\.[0-9]+)?(E-?[0-9]+)?");
      assertThat(Double.parseDouble(cells[0])).as(line).isGreaterThanOrEqualTo(lastTimeS);
      lastTimeS = Double.parseDouble(cells[0]);
      assertThat(cells[1]).as(line).matches("bot[0-3]");
      assertThat(cells[2]).as(line).isIn("joined", "moved", "left");
      for (int i = 3; i < cells.length; i++) {
        if (cells[2].equals("left")) {
          assertThat(cells[i]).as(line).isEmpty();
        } else {
          assertThat(Double.parseDouble(cells[i])).as(line).isFinite();
        }
      }
    }
    assertThat(lines).filteredOn(line -> line.contains(",joined,")).hasSize(4);
    assertThat(lines).filteredOn(line -> line.contains(",left,")).hasSize(4);
  }

  @Test
  void theSeedAloneDecides() throws IOException {
    byte[] first = trace("1", "hello", "--seed", "7", "--carrier", "platform");
    assertThat(trace("2", "hello", "--seed", "7", "--carrier", "platform")).isEqualTo(first);
    assertThat(trace("3", "hello", "--seed", "8", "--carrier", "platform")).isNotEqualTo(first);
    byte[] cars = trace("4", "intersection", "--seed", "7", "--carrier", "platform");
    assertThat(trace("5", "intersection", "--seed", "7", "--carrier", "platform")).isEqualTo(cars);
  }

  @Test
  void bothCarriersGiveTheSameTrace() throws IOException {
    assumeTrue(CarrierKind.fallbackReason() == null, "skipped: no virtual carriers here");
    byte[] platform = trace("1", "intersection", "--seed", "7", "--carrier", "platform");
    assertThat(trace("2", "intersection", "--seed", "7", "--carrier", "virtual"))
        .isEqualTo(platform);
  }

  @Test
  void aScenarioFileEqualsItsOptions() throws IOException {
    Path yaml = folder.resolve("my.yaml");
    Files.writeString(
        yaml,
        """
        # what flags can say
        app: intersection
        robots: 3
        messageLoss: 0.1
        messageDelay: uniform(10ms,50ms)
        positionNoise: 5mm
        debris: 0
        """);
    byte[] flags =
        trace(
            "1",
            "intersection --seed 3 --robots 3 --loss 0.1 --delay uniform(10ms,50ms) --gps-noise 5mm --set debris=0"
                .split(" "));
    assertThat(trace("2", yaml.toString(), "--seed", "3")).isEqualTo(flags);
    assertThat(trace("3", yaml.toString(), "--seed", "3", "--loss", "0")).isNotEqualTo(flags);
  }

  @Test
  void jsonHoldsTheResult() throws IOException {
    String png = file("a.png");
    Cli cli = Cli.run("run", "intersection", "--seed", "7", "--png", png, "--json");
    assertThat(cli.out()).hasSize(1);
    JsonNode json = new ObjectMapper().readTree(cli.text());
    assertThat(json.get("app").asText()).isEqualTo("intersection");
    assertThat(json.get("seed").asLong()).isEqualTo(7);
    assertThat(json.get("good").asBoolean()).isTrue();
    assertThat(json.get("completed").asInt()).isEqualTo(4);
    assertThat(json.get("unfinished")).isEmpty();
    assertThat(json.get("violations")).isEmpty();
    assertThat(json.get("checks").get("intersection.traffic_safety").asLong()).isPositive();
    assertThat(json.get("checks").get("mutex.Exclusive").asLong()).isPositive();
    assertThat(json.get("end_s").asDouble()).isPositive();
    assertThat(json.get("datagrams").asLong()).isPositive();
    assertThat(json.get("picture").asText()).isEqualTo(png);
  }

  @Test
  void anUnfinishedRunNamesItsRobots() {
    Cli cli =
        Cli.run("run intersection --seed 7 --for 5s --png".concat(" " + file("a.png")).split(" "));
    assertThat(cli.status()).isEqualTo(1);
    assertThat(cli.out())
        .anyMatch(line -> line.startsWith("NOT FINISHED: [bot0, bot1, bot2, bot3]"))
        .anyMatch(line -> line.startsWith("  likely cause: "));
    assertThat(cli.err())
        .containsExactly(
            "replay: ./starl run intersection --seed 7 --for 5s",
            "shrink: ./starl campaign intersection --seeds 7 --for 5s --shrink");
  }

  @Test
  void aDrawnSeedIsPrinted() {
    Cli cli = Cli.run("run", "hello", "--png", file("a.png"));
    assertThat(cli.out().get(0)).matches("hello, seed [0-9]+");
  }

  @Test
  void recordDrawsTheMomentAskedFor() throws IOException {
    List<byte[]> pictures = new ArrayList<>();
    for (String when : List.of("t=0s", "t=12s", "end", "best")) {
      Path png = folder.resolve(when + ".png");
      Cli cli =
          Cli.run("record", "intersection", "--seed", "7", "--png", when, "--out", png.toString());
      assertThat(cli.status()).as("%s", cli).isZero();
      assertThat(cli.out()).containsExactly("intersection, seed 7: " + png);
      assertIsAPicture(png);
      pictures.add(Files.readAllBytes(png));
    }
    assertThat(pictures).doesNotHaveDuplicates();
  }
}
