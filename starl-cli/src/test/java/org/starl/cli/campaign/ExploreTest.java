package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** {@code starl explore}. */
@Tag("long")
class ExploreTest {

  private static final Demos IMPATIENT = new Demos(List.of(new Impatient()));

  @TempDir private Path folder;

  private static final Channel<Boolean> WORDS =
      new Channel<>(
          "test",
          "words",
          new Codec<>() {
            @Override
            public void write(Boolean isQuestion, WireWriter out) {
              out.u8(isQuestion ? 1 : 0);
            }

            @Override
            public Boolean read(WireReader in) {
              return in.u8() == 1;
            }
          });

  /**
   * bot1 asks bot0, and takes it as an error if no answer has come after 100 ms. Datagrams take 10
   * to 20 ms unless they are explored.
   */
  private static final class Asking extends LogicThread {
    private boolean isHeard;

    Asking(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Boolean> words = gvh.comms.open(WORDS, (from, isQuestion) -> isHeard = true);
      if (gvh.id.name().name().equals("bot0")) {
        await(() -> isHeard);
        words.send(new RobotId("bot1"), false);
        return List.of();
      }
      sleep(100);
      words.send(new RobotId("bot0"), true);
      sleep(100);
      if (!isHeard) {
        throw new IllegalStateException("no answer after 100 ms");
      }
      return List.of();
    }
  }

  private static final class Impatient implements Demo {
    @Override
    public String name() {
      return "impatient";
    }

    @Override
    public String summary() {
      return "a question that must be answered soon";
    }

    @Override
    public Envelope envelope() {
      return Envelope.NETWORK;
    }

    @Override
    public Plan plan(Request request, SimSettings settings) {
      return Plan.of(
          Simulation.builder().settings(settings).robots(settings.robots(), Asking::new));
    }
  }

  private static Cli explore(String rest) {
    return Cli.run(IMPATIENT, ("explore impatient --robots 2 " + rest).split(" "));
  }

  private static String line(Cli cli, String beginning) {
    return cli.err().stream()
        .filter(line -> line.startsWith(beginning))
        .reduce((a, b) -> b)
        .orElseThrow(() -> new AssertionError(beginning + " in " + cli));
  }

  @ParameterizedTest
  @ValueSource(strings = {"random", "pct", "exhaustive"})
  void eachStrategyFindsTheAnswerThatComesTooLate(String strategy) {
    Cli cli = explore("--seed 1 --strategy " + strategy);
    assertThat(cli.status()).as("%s", cli).isEqualTo(1);
    assertThat(cli.text()).contains("went wrong");
    assertThat(line(cli, "replay: ")).contains("--fault");
    assertThat(replayed(line(cli, "replay: ").substring("replay: ./starl ".length())).status())
        .isEqualTo(1);
  }

  @Test
  void theCauseIsADatagramAndItsTwinRunGoesWell() {
    Cli cli = explore("--seed 1 --strategy exhaustive --losses 1 --delays 1ms..50ms");
    assertThat(cli.status()).as("%s", cli).isEqualTo(1);
    assertThat(line(cli, "shrunk in")).contains("1 fault");
    assertThat(line(cli, "replay: ")).contains("--fault 'datagram(bot").contains(",lost)'");
  }

  @Test
  void allStatesOfAProtocolAreVisited() {
    Cli cli = Cli.run("explore agreement --strategy states --robots 3 --set callers=1".split(" "));
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.out())
        .containsExactly(
            "agreement (robots 3, crashes 0, timers 0, callers 1, voters 0): 70 states, all that"
                + " there are, 187 steps; no invariant is violated",
            "  in 5 of them a robot knows the decision");
    Cli few = Cli.run("explore mutex --strategy states --crashes 1 --states 50 --json".split(" "));
    assertThat(few.text()).contains("\"crashes\":1", "\"states\":50", "\"complete\":false");
  }

  @Test
  void whatNoDelayAllowsIsNotFound() {
    Cli cli = explore("--seed 1 --strategy exhaustive --delays 1ms..40ms --schedules 5000");
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text()).contains("all that there are").contains("none went wrong");
  }

  @Test
  void equalSeedsPrintTheSame() {
    assertThat(explore("--seed 3 --strategy pct").text())
        .isEqualTo(explore("--seed 3 --strategy pct").text());
  }

  @Test
  void nothingChangesBeforeTheGivenTime() {
    Cli cli = explore("--seed 1 --strategy exhaustive --from 190ms --schedules 200");
    assertThat(cli.status()).as("%s", cli).isZero();
  }

  @ParameterizedTest
  @ValueSource(strings = {"random", "pct", "exhaustive"})
  void robotsThatJoinLaterAreNoFinding(String strategy) {
    Cli cli =
        Cli.run(
            ("explore intersection --set scenario=open --set arrivals=30/min --robots 3 --for 30s"
                    + " --seed 1 --schedules 12 --crashes 2 --strategy "
                    + strategy)
                .split(" "));
    assertThat(cli.status()).as("%s", cli).isZero();
  }

  @Test
  void itStartsFromATrace() throws IOException {
    Path trace = folder.resolve("good.trace");
    Path png = folder.resolve("good.png");
    String run = "run impatient --robots 2 --seed 1 --trace " + trace + " --png " + png;
    Cli.run(IMPATIENT, run.split(" "));
    Cli cli =
        Cli.run(
            IMPATIENT,
            "explore",
            "impatient",
            "--strategy",
            "exhaustive",
            "--from",
            trace + "@90ms",
            "--chart",
            folder.resolve("chart.svg").toString());
    assertThat(cli.status()).as("%s", cli).isEqualTo(1);
    assertThat(Files.readString(folder.resolve("chart.svg")))
        .startsWith("<svg")
        .contains("bot1")
        .contains("no answer after 100 ms");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "--strategy clever | --strategy: 'clever': expected one of [random, pct, exhaustive]",
        "--delays 5 | --delays: '5'",
        "--delays 9ms..5ms | --delays: '9ms..5ms': expected the earlier time first",
        "--schedules 0 | --schedules: '0'",
        "--crashes 1 | --crashes: impatient does not promise to tolerate them",
        "--crashes 1 --down 0s | --down: '0s': expected a time above 0",
        "--from none.trace@1s | none.trace: no such file",
        "--from soon | --from: 'soon'",
      })
  void aWrongOptionIsNamed(String options, String message) {
    Cli cli = explore(options);
    assertThat(cli.status()).as("%s", cli).isEqualTo(2);
    assertThat(cli.err().toString()).contains(message);
  }

  private static final String EXPLORE = "explore impatient --robots 2 ";

  private static final String TREE =
      "explore registration --robots 2 --seed 1 --strategy exhaustive --depth ";

  private void assertSharded(Demos demos, String line) {
    Cli whole = Cli.line(demos, line);
    List<Path> files = Cli.shards(demos, folder, line, 5);
    files.addAll(Cli.shards(demos, folder, line, 2));
    for (int order = 0; order < 3; order++) {
      Collections.shuffle(files, new Random(order));
      Cli.line(demos, "merge" + (line.endsWith("--json") ? " --json" : ""), files.toArray())
          .assertSame(whole);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--seed 1 --strategy random",
        "--seed 3 --strategy pct --losses 1 --json",
        "--seed 1 --strategy pct --delays 1ms..40ms --schedules 40",
        "--seed 1 --strategy exhaustive --losses 1"
      })
  void shardsMergedInAnyOrderPrintWhatOneProcessPrints(String options) {
    assertSharded(IMPATIENT, EXPLORE + options);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(strings = {"2", "2 --schedules 100"})
  void shardsOfATreePrintWhatOneProcessPrints(String depth) {
    assertSharded(Apps.ALL, TREE + depth);
  }

  @Test
  void shardsMergedMakeTheChartOfOneProcess() throws IOException {
    Path chart = folder.resolve("chart.svg");
    String options = EXPLORE + "--seed 1 --strategy exhaustive";
    Cli whole = Cli.line(IMPATIENT, options + " --chart", chart);
    String expected = Files.readString(chart);
    Files.delete(chart);
    List<Path> files = Cli.shards(IMPATIENT, folder, options, 3);
    Cli.line(IMPATIENT, "merge --chart " + chart, files.toArray()).assertSame(whole);
    assertThat(Files.readString(chart)).isEqualTo(expected);
  }

  static Stream<Arguments> drawnAndExhaustive() {
    return Stream.of(
        Arguments.of(IMPATIENT, EXPLORE + "--seed 1 --strategy random --delays 1ms..40ms"),
        Arguments.of(Apps.ALL, TREE + "1"));
  }

  @ParameterizedTest
  @MethodSource("drawnAndExhaustive")
  void anInterruptedShardIsResumedToTheSameBytes(Demos demos, String line) throws IOException {
    Path file = Cli.shard(demos, folder, line + " --schedules 30", 2, 2);
    Cli.assertResumes(demos, line + " --schedules 30 --shard 2/2", file);
  }

  @ParameterizedTest
  @MethodSource("drawnAndExhaustive")
  void aFileWithOtherRowsIsRefused(Demos demos, String line) throws IOException {
    Path one = Cli.shard(demos, folder, line, 1, 2);
    Path two = Cli.shard(demos, folder, line, 2, 2);
    Cli.line(demos, "merge", one).assertRefused("missing: expected the files of all shards");
    Path other = folder.resolve("other");
    List<String> lines = new ArrayList<>(Files.readAllLines(two));
    lines.set(2, lines.get(2).replaceFirst("\"steps\":", "\"steps\":1"));
    Files.write(other, lines);
    Cli differs = Cli.line(demos, "merge", one, two, other);
    assertThat(differs.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(differs.out()).isEmpty();
    assertThat(differs.err()).hasSize(1);
    assertThat(differs.err().getFirst())
        .startsWith("starl: determinism bug: schedule ")
        .contains("explored.steps: '");
    lines.remove(2);
    Files.write(other, lines);
    Cli.line(demos, "merge", one, other)
        .assertRefused("schedule", "is missing: expected '--resume' to complete " + other);
    Cli.line(demos, line + " --shard 2/2 --resume --out", other)
        .assertRefused("schedule", "before it");
    Cli.line(demos, "merge --csv x", one, two)
        .assertRefused("--csv cannot be used with files of 'starl explore --out'");
    Cli.line(demos, line + " --losses 1 --shard 2/2 --resume --out", two)
        .assertRefused(":1: exploration: ");
  }

  @Test
  void eachShardNeedsTheSameSeed() {
    Cli.line(IMPATIENT, EXPLORE + "--shard 1/2 --out", folder.resolve("x"))
        .assertRefused("--out and --print-job need --seed S");
    Cli.line(IMPATIENT, EXPLORE + "--seed 1 --schedules 3 --shard 1/4 --out", folder.resolve("x"))
        .assertRefused("--shard: '1/4': expected K/N", "each of 3 schedules");
    Cli.line(IMPATIENT, EXPLORE + "--seed 1 --strategy exhaustive --on spark")
        .assertRefused("--on cannot be used with --strategy exhaustive; expected --shard");
    assertThat(folder).isEmptyDirectory();
  }

  private Cli replayed(String line) {
    List<String> words = new ArrayList<>();
    Matcher word = Pattern.compile("'([^']*)'|\\S+").matcher(line);
    while (word.find()) {
      words.add(word.group(1) == null ? word.group() : word.group(1));
    }
    words.addAll(List.of("--png", folder.resolve("replay.png").toString()));
    return Cli.run(IMPATIENT, words.toArray(String[]::new));
  }
}
