package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;

/** {@code starl sweep}. */
class SweepTest {

  @TempDir private Path folder;

  private Path file(String text) throws IOException {
    return Files.writeString(folder.resolve("sweep.yaml"), text);
  }

  private static Cli sweep(Object... words) {
    List<String> all = new ArrayList<>(List.of("sweep"));
    for (Object word : words) {
      all.add(word.toString());
    }
    return Cli.run(all.toArray(String[]::new));
  }

  private static final String HELLO =
      """
      app: hello
      seeds: 3..7
      sweep:
        robots: 1..3 in 3
        positionNoise: [0, 2mm]
      show: [tasks, end_s]
      """;

  @Test
  void everyPointIsACampaignOfItsSeeds() throws IOException {
    Path csv = folder.resolve("rows.csv");
    Cli cli = sweep(file(HELLO), "--csv", csv);
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out()).hasSize(7);
    assertThat(cli.out().getFirst())
        .matches("robots +positionNoise \\[mm] +runs +good +tasks +end_s");
    List<String> lines = Files.readAllLines(csv);
    List<String> head = List.of(lines.getFirst().split(","));
    assertThat(lines).hasSize(7);
    int point = 1;
    for (String robots : List.of("1", "2", "3")) {
      for (String noise : List.of("0", "2")) {
        List<String> row = List.of(lines.get(point++).split(",", -1));
        assertThat(row).hasSameSizeAs(head).startsWith(robots, noise, "5", "5");
        assertThat(row.get(head.indexOf("tasks p90"))).isEqualTo(robots);
        Cli campaign =
            Cli.run(
                "campaign",
                "hello",
                "--seeds",
                "3..7",
                "--robots",
                robots,
                "--gps-noise",
                noise,
                "--json");
        Matcher end = Pattern.compile("\"end_s_p50\":([0-9.]+)").matcher(campaign.text());
        assertThat(end.find()).isTrue();
        assertThat(row.get(head.indexOf("end_s p50"))).isEqualTo(end.group(1));
      }
    }
  }

  @Test
  void theOutputDoesNotDependOnTheNumberOfThreads() throws Exception {
    Path sweep = file(HELLO);
    Cli one =
        sweep(sweep, "--threads", 1, "--csv", folder.resolve("1"), "--report", folder.resolve("a"));
    Cli three =
        sweep(sweep, "--threads", 3, "--csv", folder.resolve("3"), "--report", folder.resolve("b"));
    assertThat(one.out()).isEqualTo(three.out());
    assertThat(folder.resolve("3")).hasSameBinaryContentAs(folder.resolve("1"));
    assertThat(folder.resolve("b")).hasSameBinaryContentAs(folder.resolve("a"));
    String page = Files.readString(folder.resolve("a"));
    DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new ByteArrayInputStream(page.getBytes(StandardCharsets.UTF_8)));
    assertThat(page)
        .contains("end_s against robots", "end_s against positionNoise", "tasks against robots");
  }

  @Test
  void samplesFillEachPartOfEachRangeOnce() throws IOException {
    SweepFile sweep =
        SweepFile.read(
            file("""
            app: hello
            seeds: 1
            samples: 20
            sampleSeed: 5
            sweep:
              messageLoss: 0.0..0.4
              robots: 1..40
              positionNoise: [0, 1mm, 2mm, 3mm]
            """)
                .toString());
    List<List<String>> points = sweep.points();
    assertThat(points).hasSize(20).isEqualTo(sweep.points());
    TreeSet<Integer> parts = new TreeSet<>();
    points.forEach(point -> parts.add((int) (Double.parseDouble(point.get(0)) / 0.02)));
    assertThat(parts).hasSize(20);
    assertThat(points).allMatch(point -> point.get(1).matches("[1-9]|[1-3][0-9]|40"));
    for (String noise : List.of("0", "1mm", "2mm", "3mm")) {
      assertThat(points).filteredOn(point -> point.get(2).equals(noise)).hasSize(5);
    }
    // The order of one key's values says nothing of another's.
    assertThat(points.stream().map(point -> point.get(0)).toList())
        .isNotEqualTo(points.stream().map(point -> point.get(0)).sorted().toList());
  }

  @Test
  void theFirstBadRunIsToldWithItsReplay() throws IOException {
    Cli cli =
        sweep(
            file(
                """
                app: hello
                seeds: 1..2
                sweep:
                  duration: [60s, 100ms]
                """));
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(cli.err())
        .anyMatch(line -> line.startsWith("seed 1: not finished"))
        .contains("replay: ./starl run hello --seed 1 --for 100ms");
  }

  @Test
  void shardsMergedInAnyOrderMakeTheFilesOfOneProcess() throws IOException {
    Path sweep = file(HELLO.replace("robots: 1..3 in 3", "duration: [60s, 100ms, 50s]"));
    Path csv = folder.resolve("rows.csv");
    Path page = folder.resolve("page.html");
    Cli whole = sweep(sweep, "--csv", csv, "--report", page);
    assertThat(whole.status()).as("%s", whole).isEqualTo(ExitStatus.VIOLATED);
    String rows = Files.readString(csv);
    String html = Files.readString(page);
    List<Path> files = Cli.shards(Apps.ALL, folder, "sweep " + sweep, 7);
    files.addAll(Cli.shards(Apps.ALL, folder, "sweep " + sweep, 2));
    Files.delete(sweep);
    for (int order = 0; order < 3; order++) {
      Files.delete(csv);
      Files.delete(page);
      Collections.shuffle(files, new Random(order));
      String merge = "merge --csv " + csv + " --report " + page;
      Cli.line(Apps.ALL, merge, files.toArray()).assertSame(whole);
      assertThat(Files.readString(csv)).isEqualTo(rows);
      assertThat(Files.readString(page)).isEqualTo(html);
    }
    files.removeIf(file -> !file.toString().endsWith("-of-7") || file.toString().contains("-3-"));
    Cli.line(Apps.ALL, "merge", files.toArray()).assertRefused("runs 9..12 of 1..30 are missing");
  }

  @Test
  void thePageHasAVerdictAndAReplayOfEachPoint() throws IOException {
    Path sweep = file(HELLO.replace("robots: 1..3 in 3", "duration: [60s, 100ms]"));
    Path page = folder.resolve("page.html");
    Cli cli = sweep(sweep, "--report", page);
    assertThat(cli.status()).as("%s", cli).isEqualTo(ExitStatus.VIOLATED);
    String text = Files.readString(page).replaceAll("</?span[^>]*>", "");
    assertThat(text).containsPattern("class=\"verdict bad\">.{1,40}of .{1,9}runs did not go well");
    assertThat(text).containsPattern("run hello --seed [0-9]+ --for 100ms");
    assertThat(text).containsPattern("run hello --seed [0-9]+ --for 60s");
    assertThat(text).contains("<a href=\"#points\">Points</a>");
  }

  @Test
  void anInterruptedShardIsResumedToTheSameBytes() throws IOException {
    String line = "sweep " + file(HELLO) + " --shard 2/2";
    Path part = folder.resolve("part");
    assertThat(Cli.line(Apps.ALL, line + " --out", part).status()).isZero();
    Cli.assertResumes(Apps.ALL, line, part);
  }

  @Test
  void aMeasureThatNoPointHasIsToldAfterOneRunOfEach() throws IOException {
    Path sweep = file(HELLO.replace("[tasks, end_s]", "\n  - tasks\n  - crossed"));
    Path part = folder.resolve("part");
    Cli cli = Cli.line(Apps.ALL, "sweep " + sweep + " --shard 1/2 --out", part);
    cli.assertRefused("sweep.yaml:6: show: 'crossed': expected some of ", " tasks ");
    // The header, and five points; the sixth completes the measures.
    assertThat(Files.readAllLines(part)).hasSize(6);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "seeds: 1..2 | sweep.yaml:1: sweep: expected settings with their values",
        "sweep: {robots: [1, 2]} | sweep.yaml:1: seeds: '': expected the seeds of each point",
        "seeds: [1, 2];sweep: {robots: [1]} | sweep.yaml:2: seeds: a list of 2: expected the seeds",
        "seeds: 1;sweep: {robots: {a: 1}} | sweep.yaml:3: robots: a mapping: expected a list such",
        "seeds: x;sweep: {robots: [1]} | sweep.yaml:2: seeds: 'x': expected",
        "seeds: 1;sweep: {robots: many} | sweep.yaml:3: robots: 'many': expected a list",
        "seeds: 1;sweep: {robots: 5..2 in 3} | sweep.yaml:3: robots: '5..2 in 3': expected a list",
        "seeds: 1;sweep: {delay: 1ms..2s in 3} | delay: '1ms..2s in 3': expected a list",
        "seeds: 1;sweep: {robots: 1..4} | robots: expected a number of values, 'in 5'",
        "seeds: 1;robots: 2;sweep: {robots: [1]} | robots: expected it either fixed or under",
        "seeds: 1;sweep: {robot: [1]} | sweep.yaml:3: no setting or parameter is called 'robot'",
        "seeds: 1;sweep: {messageLoss: [0, 7]} | sweep.yaml:3: messageLoss='7': expected a probability",
        "seeds: 1;sweep: {floorWidth: [8m, 1mm]} | sweep.yaml:3: the point floorWidth=1mm: ",
        "seeds: 1;samples: 0;sweep: {robots: [1]} | sweep.yaml:3: samples: '0': expected",
        "seeds: 1;show: [x];sweep: {robots: [1]} | sweep.yaml:3: show: 'x': expected some of ",
        "seeds: 1..9999999;sweep: {robots: [1]} | expected at most 10000 points and 1000000 runs"
      })
  void badInputIsToldInOneLine(String line) throws IOException {
    String[] parts = line.split(" \\| ");
    Path csv = folder.resolve("rows.csv");
    Cli cli = sweep(file("app: hello\n" + parts[0].replace(";", "\n") + "\n"), "--csv", csv);
    List<String> err = cli.err().stream().filter(text -> !text.matches("\\d+ of .*")).toList();
    assertThat(cli.status()).as("%s", cli).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err).as("%s", cli).hasSize(1);
    assertThat(err.getFirst()).startsWith("starl: ").contains("sweep.yaml").contains(parts[1]);
    assertThat(csv).doesNotExist();
  }

  @Test
  void theExampleOfTheDocsIsASweep() {
    SweepFile sweep = SweepFile.read("../scenarios/sweeps/open-road.yaml");
    assertThat(sweep.points()).hasSize(18).contains(List.of("12/min", "0.2"));
    sweep.points().forEach(point -> sweep.request(Apps.ALL, point));
  }
}
