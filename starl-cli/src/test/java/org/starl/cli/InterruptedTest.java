package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchService;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A long command that a signal stops prints what it has, and how to go on. */
@Tag("realtime")
class InterruptedTest {

  private static final Pattern LAST =
      Pattern.compile(
          "interrupted after (\\d+) of 1000000 runs; to go on: \\S+ campaign hello --seeds (\\d+)\\.\\.1000000 --threads 1");

  @TempDir private Path folder;

  /** A command's output after a signal. */
  private record Ended(int status, List<String> out, List<String> err) {}

  /** Signals as soon as a line on standard error shows progress. */
  private static Ended run(String signal, String progress, List<String> words) throws Exception {
    assumeFalse(
        signal.equals("INT") && ignoresInt(), "INT is ignored, as in a shell's background job");
    Process process = start(words);
    try (BufferedReader err = process.errorReader(StandardCharsets.UTF_8);
        BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      String line = err.readLine();
      while (line != null && !line.matches(progress)) {
        line = err.readLine();
      }
      signal(signal, process);
      List<String> printed = out.lines().toList();
      List<String> errors = err.lines().toList();
      return new Ended(process.waitFor(), printed, errors);
    }
  }

  private static Process start(List<String> words) throws IOException {
    return new ProcessBuilder(Cli.process(words.toArray(String[]::new))).start();
  }

  private static void signal(String signal, Process process) throws Exception {
    new ProcessBuilder("kill", "-" + signal, "" + process.pid()).start().waitFor();
  }

  /** Whether this process, and so its children, ignore the signal INT, which has the number 2. */
  private static boolean ignoresInt() throws IOException {
    Path status = Path.of("/proc/self/status");
    return Files.exists(status)
        && Files.readAllLines(status).stream()
            .filter(line -> line.startsWith("SigIgn:"))
            .anyMatch(line -> (Long.parseUnsignedLong(line.split("\\s+")[1], 16) & 2) != 0);
  }

  @ParameterizedTest
  @CsvSource({"INT, 130", "TERM, 143"})
  void theTableSoFarAndTheCommandThatGoesOnArePrinted(String signal, int status) throws Exception {
    Ended ended =
        run(
            signal,
            "[1-9]\\d* of 1000000 runs.*",
            List.of("campaign", "hello", "--seeds", "1..1000000", "--threads", "1"));
    assertThat(ended.status()).isEqualTo(status);
    Matcher last = LAST.matcher(ended.err().getLast());
    assertThat(last.matches()).as("%s", ended).isTrue();
    long done = Long.parseLong(last.group(1));
    assertThat(Long.parseLong(last.group(2))).isEqualTo(done + 1);
    assertThat(ended.out()).anyMatch(row -> row.matches("runs +" + done));
    assertThat(ended.out()).anyMatch(row -> row.startsWith("bad runs: 0 of " + done + ": below "));
  }

  @Test
  void aReportIsWrittenWithoutRepeatingBadRuns() throws Exception {
    Path page = folder.resolve("page.html");
    Ended ended =
        run(
            "TERM",
            "[1-9]\\d* of 100000 runs.*",
            List.of(
                "campaign",
                "mutex",
                "--seeds",
                "1..100000",
                "--for",
                "2s",
                "--threads",
                "1",
                "--report",
                page.toString()));
    assertThat(ended.status()).isEqualTo(143);
    assertThat(ended.out().getLast()).isEqualTo("report: " + page);
    assertThat(ended.err())
        .noneMatch(line -> line.contains("repeated for pictures"))
        .anyMatch(
            line -> line.matches("interrupted: the report has pictures of 0 of \\d+ bad runs"));
    assertThat(Files.readString(page)).contains("did not go well");
  }

  @Test
  void aSweepWritesItsTablesSoFar() throws Exception {
    Path file = folder.resolve("sweep.yaml");
    Path csv = folder.resolve("table.csv");
    Files.writeString(
        file, "app: hello\nrobots: 2\nseeds: 1..400000\nsweep:\n  messageLoss: [0, 0.1]\n");
    Ended ended =
        run(
            "INT",
            "[1-9]\\d* of 800000 runs.*",
            List.of("sweep", file.toString(), "--csv", csv.toString(), "--threads", "1"));
    assertThat(ended.status()).isEqualTo(130);
    assertThat(ended.out().getFirst()).contains("runs", "good");
    assertThat(Files.readAllLines(csv)).hasSize(3);
    assertThat(ended.err().getLast())
        .matches("interrupted after [1-9]\\d* of 800000 runs; .* --out FILE, .*--resume.*");
  }

  @ParameterizedTest
  @ValueSource(strings = {"pct", "exhaustive"})
  void anExplorationPrintsWhatItHasSeen(String strategy) throws Exception {
    Ended ended =
        run(
            "TERM",
            "[1-9]\\d* of 9000000 schedules.*",
            List.of(
                ("explore mutex --robots 2 --seed 1 --threads 1 --schedules 9000000 --depth 60 --strategy "
                        + strategy)
                    .split(" ")));
    assertThat(ended.status()).isEqualTo(143);
    assertThat(ended.out()).hasSize(1);
    assertThat(ended.out().getFirst()).contains("none went wrong").doesNotContain("all that");
    assertThat(ended.err().getLast()).startsWith("interrupted after ").contains("schedules");
  }

  @Test
  void aShardTellsTheCommandThatContinuesItsFile() throws Exception {
    Path rows = folder.resolve("rows");
    String words = "campaign hello --seeds 1..1000000 --threads 1 --out " + rows;
    Ended ended = run("INT", "[1-9]\\d* of 1000000 runs.*", List.of(words.split(" ")));
    assertThat(ended.err().getLast())
        .startsWith("interrupted after ")
        .endsWith(words + " --resume");
    long done = Files.readAllLines(rows).size() - 1;
    assertThat(ended.err().getLast()).contains("after " + done + " of 1000000 runs");
  }

  @ParameterizedTest
  @CsvSource({
    "explore mutex --strategy states --robots 4 --states 100000000, states",
    "bench b1 --robots 2000 --runs 100000, runs",
    "bench b5 --runs 100000, runs",
    "campaign hello --seeds 1..500000 --split fault.restart, seeds"
  })
  void aCommandThatCannotEndEarlySaysHowFarItWas(String words, String units) throws Exception {
    Ended ended = run("INT", "[1-9]\\d* of \\d+ " + units + ".*", List.of(words.split(" ")));
    assertThat(ended.status()).isEqualTo(130);
    assertThat(ended.err().getLast())
        .matches("starl: interrupted after [1-9]\\d* of \\d+ " + units);
  }

  @Test
  void proveEndsThoughItsSolverTakesTheSignal() throws Exception {
    assumeFalse(ignoresInt(), "INT is ignored, as in a shell's background job");
    Path kept = Files.createDirectory(folder.resolve("kept"));
    try (WatchService questions = kept.getFileSystem().newWatchService()) {
      kept.register(questions, StandardWatchEventKinds.ENTRY_CREATE);
      Process process =
          start(List.of("prove", "../pvs/starl/Traffic_decls.starl", "--keep", kept.toString()));
      questions.take(); // the solver is asked
      signal("INT", process);
      try (BufferedReader err = process.errorReader(StandardCharsets.UTF_8)) {
        assertThat(err.lines()).last().asString().startsWith("starl: interrupted");
      }
      assertThat(process.waitFor()).isEqualTo(130);
    }
  }

  @Test
  void theSmallestRunSoFarIsPrinted() throws Exception {
    Ended ended =
        run(
            "INT",
            "shrink 1: .*",
            List.of(
                "campaign",
                "intersection",
                "--set",
                "scenario=figure7",
                "--seeds",
                "7..7",
                "--fault",
                "jump(bot1,600mm,at=2s)",
                "--for",
                "60s",
                "--shrink"));
    assertThat(ended.out()).anyMatch(row -> row.matches(" +unfinished +1"));
    assertThat(ended.err())
        .anyMatch(
            line -> line.startsWith("shrunk in ") && line.endsWith("(a smaller one may exist)"));
  }
}
