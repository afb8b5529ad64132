package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.command.ExitStatus;
import org.starl.sim.Setting;
import org.starl.spec.Require;
import org.starl.workload.PrimitiveWorkloads;

class SteeredTest {

  private static final Demo MUTEX = new Demos(PrimitiveWorkloads.ALL).byName("mutex").orElseThrow();
  private static final Demos MUTEXES = new Demos(List.of(new Mutex(false), new Mutex(true)));

  @TempDir private Path folder;

  /** The workload of a mutex. */
  private static final class Mutex extends HelloWithATwist {
    private final boolean isBad;

    /**
     * @param isBad whether it violates a lemma in a run with redraws
     */
    Mutex(boolean isBad) {
      super(MUTEX, isBad ? "bad" : "good", MUTEX.summary());
      this.isBad = isBad;
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      boolean isRedrawn = plan.simulation().settings().has(Setting.REDRAWS);
      plan.simulation()
          .monitor(() -> Require.always("seed", "it is a seed's", state -> !isBad || !isRedrawn));
      return plan;
    }
  }

  private static Cli campaign(String name, Object... more) {
    String line = "campaign " + name + " --chaos --robots 3 --seeds 1..8 --set rounds=4";
    return Cli.line(MUTEXES, line, more);
  }

  @Test
  void aCampaignWithChaosGoesOnNearWhatFewSeedsReached() {
    Cli one = campaign("good", "--threads", "1");
    campaign("good", "--threads", "2").assertSame(one);
    assertThat(one.status()).isEqualTo(ExitStatus.GOOD);
    assertThat(one.out()).contains("steered: 4 further runs near what few seeds reached, 0 bad");
  }

  @Test
  void withoutChaosNoRunIsSteered() {
    Cli cli = Cli.line(MUTEXES, "campaign bad --robots 3 --seeds 1..8 --set rounds=4");
    assertThat(cli.status()).isEqualTo(ExitStatus.GOOD);
    assertThat(cli.out()).noneMatch(line -> line.startsWith("steered"));
  }

  @Test
  void aBadSteeredRunFailsTheCampaignAndItsReplayShowsIt() {
    Path page = folder.resolve("page.html");
    Cli cli = campaign("bad", "--report", page.toString());
    assertThat(cli.status()).isEqualTo(ExitStatus.VIOLATED);
    String steered = "steered: 4 further runs near what few seeds reached, 4 bad";
    assertThat(cli.out()).contains(steered);
    assertThat(cli.out()).anyMatch(line -> line.startsWith("bad runs: 0 of 8"));
    assertThat(page).content().contains(steered);
    String replay = cli.err().getLast();
    assertThat(replay).startsWith("replay: ./starl run bad --seed ").contains("redraws=");
    String command = replay.substring("replay: ./starl ".length()).replace("'", "");
    Cli again = Cli.line(MUTEXES, command, "--png", folder.resolve("replay.png").toString());
    assertThat(again.out()).anyMatch(line -> line.startsWith("VIOLATED: seed"));
  }
}
