package org.starl.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;
import org.starl.id.RobotId;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.fault.Envelope;

/** {@code starl explore}. */
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
