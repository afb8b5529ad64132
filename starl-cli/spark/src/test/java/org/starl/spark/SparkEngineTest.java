package org.starl.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.cli.Main;

/** {@code starl campaign --on spark}, with Spark in this process. */
@Tag("long")
class SparkEngineTest {

  @TempDir private Path folder;

  private record Result(int status, String out, List<String> err) {}

  private static Result run(String line, Object... more) {
    List<String> words = new ArrayList<>(Arrays.asList(line.split(" ")));
    for (Object word : more) {
      words.add(word.toString());
    }
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status = Main.run(new PrintWriter(out), new PrintWriter(err), words.toArray(String[]::new));
    return new Result(status, out.toString(), err.toString().lines().toList());
  }

  /** Without the progress and the speed, which depend on the machine. */
  private static List<String> messages(Result result) {
    return result.err().stream()
        .filter(line -> !line.matches("\\d+ of \\d+ .*|[0-9,]+ steps a second|bad so far: .*"))
        .toList();
  }

  private static void assertSame(Result actual, Result expected) {
    assertThat(actual.out()).isEqualTo(expected.out());
    assertThat(messages(actual)).isEqualTo(messages(expected));
    assertThat(actual.status()).isEqualTo(expected.status());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "campaign rarely-bad --seeds 3..260 --set one-of=50 --loss 0.1 --chaos",
        "campaign rarely-bad --seeds 1..400 --robots 1 --set one-of=120 --stop --json",
        "campaign hello --seeds 1..300 --robots 1 --until 95%<5e-2",
        "explore registration --robots 2 --seed 1 --schedules 230 --strategy random",
        "explore rarely-bad --robots 1 --seed 17 --schedules 5 --json"
      })
  void sparkPrintsWhatOneProcessPrints(String line) {
    assertSame(run(line + " --threads 2 --on spark"), run(line));
  }

  @Test
  void sparkSweepsToTheSameFiles() throws IOException {
    Path sweep = folder.resolve("sweep.yaml");
    Files.writeString(sweep, "app: hello\nseeds: 1..60\nsweep: {robots: [1, 2, 3]}\n");
    Path csv = folder.resolve("rows.csv");
    Result expected = run("sweep", sweep, "--csv", csv);
    String text = Files.readString(csv);
    Files.delete(csv);
    assertSame(run("sweep --on spark", sweep, "--csv", csv), expected);
    assertThat(Files.readString(csv)).isEqualTo(text);
  }

  @Test
  void sparkMakesThePageOfOneProcess() throws IOException {
    String campaign = "campaign rarely-bad --seeds 3..40 --set one-of=20";
    Path page = folder.resolve("page.html");
    Result expected = run(campaign + " --report", page);
    String text = Files.readString(page);
    Files.delete(page);
    assertSame(run(campaign + " --on spark --report", page), expected);
    assertThat(Files.readString(page)).isEqualTo(text);
  }

  @Test
  void aRareBugIsFoundAndShrunkOnTheDriver() {
    Result result =
        run("campaign rarely-bad --seeds 5000..24999 --robots 2 --ideal --shrink --on spark");
    assertThat(result.status()).isOne();
    assertThat(result.out()).contains("bad runs: 2 of 20000: ");
    assertThat(result.err())
        .anyMatch(line -> line.startsWith("seed 10017: stands_still violated "))
        .anyMatch(line -> line.matches("shrunk in \\d+ runs: 2 robots.* -> 1 robot.*"));
  }

  @Test
  void theParquetFilesHaveTheRunsOfTheResult() throws IOException {
    Path parquet = folder.resolve("rows");
    String campaign = "campaign rarely-bad --seeds 1..400 --robots 1 --set one-of=120 --stop";
    assertThat(run(campaign + " --on spark --parquet", parquet).status()).isOne();
    try (SparkSession session =
        SparkSession.builder().config(SparkEngine.conf("", 1)).getOrCreate()) {
      Dataset<Row> rows = session.read().parquet(parquet.toString()).orderBy("seed");
      assertThat(rows.columns()).contains("seed", "verdict", "end_s", "failure", "failure_at_s");
      assertThat(rows.count()).isEqualTo(17);
      assertThat(rows.filter("verdict = 'GOOD'").count()).isEqualTo(16);
      Row last = rows.filter("verdict = 'VIOLATED'").first();
      assertThat(last.<Long>getAs("seed")).isEqualTo(17);
      assertThat(last.<String>getAs("failure")).isEqualTo("stands_still");
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--on flink | --on: 'flink': expected spark or spark=MASTER",
        "--on spark=here | --on: 'here': cannot be used (",
        "--on spark --parquet . | --parquet: '.': expected the name of a new folder",
        "--parquet rows | --parquet needs --on ENGINE",
        "--on spark --out rows | --on cannot be used with --out"
      })
  void badOptionsAreToldInOneLine(String line) {
    String[] parts = line.split(" \\| ");
    Result result = run("campaign hello --seeds 1..10 " + parts[0]);
    assertThat(result.status()).as("%s", result).isEqualTo(2);
    assertThat(result.err()).as("%s", result).hasSize(1);
    assertThat(result.err().getFirst()).startsWith("starl: ").contains(parts[1]);
  }
}
