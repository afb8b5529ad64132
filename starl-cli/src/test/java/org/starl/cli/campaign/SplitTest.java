package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.report.Report;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.TraceEvent;

class SplitTest {

  private static final Demos UNLUCKY = new Demos(List.of(new Unlucky()));
  private static final String CAMPAIGN =
      "campaign unlucky --robots 1 --set speedError=0.2 --split motion.doMove --copies 5 --seeds ";

  @TempDir private Path folder;

  /** Hello, whose robots must not arrive in every fifth period of their motion. */
  private static final class Unlucky extends HelloWithATwist {
    Unlucky() {
      super("unlucky", "hello that must not arrive at some times");
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      plan.simulation().monitor(Periods::new);
      return plan;
    }

    private static final class Periods extends LemmaMonitor {
      Periods() {
        lemma("lucky", "No robot arrives in a fifth period.");
      }

      @Override
      public void observe(TraceEvent event, Report report) {
        if (event instanceof TraceEvent.Variable variable
            && variable.value().toString().equals("DONE")) {
          report.checked("lucky");
          if (event.timeNs() / 20_000_000 % 5 == 0) {
            report.violated("lucky", event.timeNs(), List.of(event.robot()), "arrives");
          }
        }
      }
    }
  }

  @Test
  void aSplitCampaignPrintsAnEstimateThatDoesNotDependOnThreads() {
    Cli one = Cli.run(UNLUCKY, (CAMPAIGN + "1..40 --threads 1").split(" "));
    Cli two = Cli.run(UNLUCKY, (CAMPAIGN + "1..40 --threads 2").split(" "));
    two.assertSame(one);
    assertThat(one.status()).isEqualTo(ExitStatus.VIOLATED);
    assertThat(one.out())
        .startsWith(
            "unlucky: 40 seeds, 200 runs, 5 copies at each level",
            "  level 1: reached by 40 seeds");
    assertThat(one.out().getLast())
        .isEqualTo(
            "bad runs: 29 of 40 seeds have one; probability 22 %, from 14 % to 30 % at 95 %");
  }

  @Test
  void theReplayOfABadCopyShowsIt() {
    long redrawn = 0;
    for (int seed = 1; seed <= 12; seed++) {
      Cli cli = Cli.run(UNLUCKY, (CAMPAIGN + seed + ".." + seed).split(" "));
      if (cli.status() == ExitStatus.VIOLATED) {
        String replay = cli.err().getLast();
        assertThat(replay).startsWith("replay: ./starl run unlucky --seed " + seed);
        redrawn += replay.contains("redraws=") ? 1 : 0;
        String command = replay.substring("replay: ./starl ".length()).replace("'", "");
        Cli again = Cli.line(UNLUCKY, command, "--png", folder.resolve("replay.png").toString());
        assertThat(again.status()).as(command).isEqualTo(ExitStatus.VIOLATED);
        String violation = cli.messages().get(cli.messages().size() - 2);
        assertThat(again.out())
            .contains("VIOLATED: " + violation.substring(("seed " + seed + ": ").length()));
      }
    }
    assertThat(redrawn).as("bad copies").isPositive();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --split restart                            | --split | 'restart' | expected SOURCE.NAME
          --split a.b,a.b,a.b --copies 60            | --split | 3 levels, 60 copies | 100000
          --split a.b --copies 1                     | --copies | '1' | expected
          --split a.b --set redraws=1s#2             | --split | redraws | cannot
          --split a.b --stop                         | --stop | --split | cannot
          """)
  void whatCannotSplitIsRefused(String options, String first, String second, String third) {
    Cli.run(UNLUCKY, ("campaign unlucky --seeds 1..2 " + options).split(" "))
        .assertRefused(first, second, third);
  }
}
