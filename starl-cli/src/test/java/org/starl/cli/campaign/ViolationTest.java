package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.InflaterInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.Demos;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.StandsStill;
import org.starl.cli.report.Report;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.TraceEvent;

/** Campaigns, and the messages about violations and about apps that throw. */
class ViolationTest {

  private static final Demos BROKEN = new Demos(List.of(new Broken()));

  @TempDir private Path folder;

  /** Hello, with a specification that does not hold for every third seed. */
  private static final class Broken extends HelloWithATwist {
    Broken() {
      super("broken", "hello that stands still");
    }

    @Override
    public List<Parameter> parameters() {
      return List.of(new Parameter("every", "3", "seeds that are bad"));
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      if (request.seed() % Long.parseLong(request.parameter("every")) == 0) {
        plan.simulation().monitor(StandsStill::new);
      }
      return plan;
    }
  }

  /** Runs a command as pasted; none of its words contains a space. */
  private Cli paste(String line) {
    List<String> words = new ArrayList<>();
    for (String word : line.substring("replay: ./starl ".length()).split(" ")) {
      words.add(word.startsWith("'") ? word.substring(1, word.length() - 1) : word);
    }
    words.addAll(List.of("--png", folder.resolve("replay.png").toString()));
    return Cli.run(BROKEN, words.toArray(String[]::new));
  }

  /** Hello, with a lemma that is never checked. */
  private static final class Unknown extends HelloWithATwist {
    Unknown() {
      super("unknown", "hello that is not watched");
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      plan.simulation().monitor(Blind::new);
      return plan;
    }

    private static final class Blind extends LemmaMonitor {
      Blind() {
        lemma("not_here", "Nothing is known of it.");
      }

      @Override
      public void observe(TraceEvent event, Report report) {}
    }
  }

  @Test
  void aCampaignOfAHundredRunsFailsIfALemmaWasNeverChecked() {
    Demos demos = new Demos(List.of(new Unknown()));
    Cli many = Cli.run(demos, "campaign unknown --seeds 1..100 --robots 1".split(" "));
    assertThat(many.err())
        .contains("never checked in 100 runs: not_here: expected a check in some run");
    assertThat(many.status()).isEqualTo(1);
    Cli few = Cli.run(demos, "campaign unknown --seeds 1..2 --robots 1".split(" "));
    assertThat(few.err()).contains("never checked in 2 runs: not_here");
    assertThat(few.status()).isZero();
  }

  @Test
  void aCampaignBoundsTheProbabilityOfABadRunForEachKindOfFault() {
    Cli cli = Cli.run("campaign hello --seeds 1..59 --fault loss(0.1,at=0s,for=11s)".split(" "));
    assertThat(cli.out())
        .contains(
            "bad runs: 0 of 59: below 5.0 % at 95 %", "  with loss: 0 of 59: below 5.0 % at 95 %");
  }

  @Test
  void aCampaignReportsTheFirstViolationWithItsReplay() {
    Cli cli =
        Cli.run(
            BROKEN,
            "campaign broken --seeds 1..7 --loss 0.1 --delay uniform(10ms,20ms) --set robots=2"
                .split(" "));
    assertThat(cli.status()).isEqualTo(1);
    assertThat(cli.text()).containsPattern("runs +7\n").containsPattern("violated +2\n");
    String violation = cli.err().get(cli.err().size() - 3);
    String replay = cli.err().get(cli.err().size() - 1);
    assertThat(cli.err()).contains("  stands_still: No robot drives.");
    assertThat(violation).matches("seed 3: stands_still violated at [0-9.]+ s by bot[01]: drives");
    assertThat(replay)
        .isEqualTo(
            "replay: ./starl run broken --seed 3 --robots 2 --loss 0.1"
                + " --delay 'uniform(10ms,20ms)'");
    Cli again = paste(replay);
    assertThat(again.status()).isEqualTo(1);
    assertThat(again.out()).contains("VIOLATED: " + violation.substring("seed 3: ".length()));
    assertThat(again.out()).contains("  stands_still: No robot drives.");
    assertThat(again.err())
        .containsExactly(
            replay,
            "shrink: ./starl campaign broken --seeds 3 --robots 2 --loss 0.1"
                + " --delay 'uniform(10ms,20ms)' --shrink");
  }

  @Test
  void recordReportsTheViolation() {
    Path png = folder.resolve("a.png");
    Cli cli = Cli.run(BROKEN, "record", "broken", "--seed", "3", "--out", png.toString());
    assertThat(cli.status()).isEqualTo(1);
    assertThat(cli.err()).anyMatch(line -> line.startsWith("VIOLATED: stands_still"));
    assertThat(cli.err()).contains("replay: ./starl run broken --seed 3");
    assertThat(png).exists();
  }

  @Test
  void aThrowingRunKeepsItsTraceAndReplay() {
    Path trace = folder.resolve("a.trace");
    Cli cli =
        Cli.run(
            new Demos(List.of(new Throwing())),
            "run throwing --seed 3 --trace %s --png %s"
                .formatted(trace, folder.resolve("a.png"))
                .split(" "));
    assertThat(cli.status()).isEqualTo(1);
    assertThat(cli.err())
        .containsExactly(
            "replay: ./starl run throwing --seed 3",
            "shrink: ./starl campaign throwing --seeds 3 --shrink",
            "starl: throwing, seed 3: at 1000000000 ns: java.lang.IllegalStateException: thrown on"
                + " purpose (--stacktrace shows details)");
    assertThat(trace).isNotEmptyFile();
    assertThat(cli.out()).isEmpty();
  }

  @Test
  void thePageOfAThrowingRunShowsTheError() throws Exception {
    Path page = folder.resolve("a.html");
    Cli cli =
        Cli.run(
            new Demos(List.of(new Throwing())),
            "record throwing --seed 3 --html %s".formatted(page).split(" "));
    assertThat(cli.status()).isEqualTo(1);
    Matcher packed =
        Pattern.compile("<script id=\"run\" [^>]*>([^<]*)").matcher(Files.readString(page));
    assertThat(packed.find()).isTrue();
    byte[] bytes = Base64.getDecoder().decode(packed.group(1));
    JsonNode run =
        new ObjectMapper().readTree(new InflaterInputStream(new ByteArrayInputStream(bytes)));
    assertThat(run.get("failure").get("headline").asText())
        .isEqualTo("at 1000000000 ns: java.lang.IllegalStateException: thrown on purpose");
  }

  /** A scenario with a bug. */
  private static final class Throwing extends HelloWithATwist {
    Throwing() {
      super("throwing", "hello that ends early");
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      plan.simulation()
          .director(control ->
              control.at(
                  1_000_000_000,
                  () -> {
                    throw new IllegalStateException("thrown on purpose");
                  }));
      return plan;
    }
  }

  @Test
  void aGoodCampaignIsTheSameOnAnyNumberOfThreads() throws IOException {
    List<String> texts = new ArrayList<>();
    for (String threads : List.of("1", "2", "5")) {
      Cli cli =
          Cli.run(
              "campaign intersection --seeds 1..6 --robots 2 --json --threads"
                  .concat(" " + threads)
                  .split(" "));
      assertThat(cli.status()).as("%s", cli).isZero();
      assertThat(cli.out()).hasSize(1);
      texts.add(cli.text());
    }
    assertThat(texts).containsOnly(texts.get(0));
    JsonNode json = new ObjectMapper().readTree(texts.get(0));
    assertThat(json.get("app").asText()).isEqualTo("intersection");
    assertThat(json.get("seeds").asText()).isEqualTo("1..6");
    assertThat(json.get("good").asInt()).isEqualTo(6);
    assertThat(json.get("violated").asInt()).isZero();
    assertThat(json.get("completed").asInt()).isEqualTo(12);
    assertThat(json.get("wait_p99_s").asDouble()).isPositive();
    assertThat(json.get("datagrams_sent_p50").asDouble()).isPositive();
    assertThat(json.has("first_bad_seed")).isFalse();
  }

  @Test
  void runAndCampaignSayWhatTheTasksAre() {
    Cli run = Cli.run("run fleet --seed 1 --robots 2 --set deliveries=3".split(" "));
    assertThat(run.text()).contains("3 of 3 deliveries finished in ");
    Cli campaign = Cli.run("campaign maze --seeds 1..2 --robots 1".split(" "));
    assertThat(campaign.text()).containsPattern("goals finished +2\n");
  }

  @Test
  void aCampaignsTableHasCrossingsWaitsAndMessages() {
    Cli cli = Cli.run("campaign intersection --seeds 8001..8002 --robots 2".split(" "));
    assertThat(cli.status()).isZero();
    assertThat(cli.text())
        .containsPattern("runs +2\n")
        .containsPattern("robots finished +4\n")
        .containsPattern("wait, median +[0-9.]+ s\n")
        .containsPattern("datagrams_sent per run, median +[0-9]+\n");
    assertThat(Cli.run("campaign hello --seeds 1..2".split(" ")).text()).doesNotContain("wait, ");
    // Seeds of no other test: `run` writes a picture of each run into this folder.
    assertThat(Files.exists(Path.of("out", "intersection-8001.png"))).isFalse();
  }
}
