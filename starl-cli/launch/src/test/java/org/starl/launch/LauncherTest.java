package org.starl.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.sim.SimulationPlan;

/** What the launcher does when a process fails. */
@Tag("realtime")
class LauncherTest {

  private final List<String> told = new ArrayList<>();

  private LaunchResult run(String main) throws IOException {
    return run(main, FaultyMain.plan(), Duration.ofSeconds(150));
  }

  private LaunchResult run(String main, SimulationPlan plan, Duration limit) throws IOException {
    List<String> command = JavaProcess.command(128, main, List.of());
    LaunchSettings settings = new LaunchSettings(1, List.of(), limit, LaunchSettings.DEFAULT_QUIET);
    try (Launcher launcher =
        new Launcher(plan, command, PrimitiveVocabulary.ALL, settings, told::add)) {
      return launcher.run();
    }
  }

  @Test
  void aBugInAProcessEndsTheRunAndIsReported() throws IOException {
    LaunchResult result = run(FaultyMain.class.getName());
    assertThat(result.isSafe()).isFalse();
    assertThat(result.errors()).as("%s", told).hasSize(1);
    assertThat(result.errors().get(0))
        .startsWith("bot1: java.lang.IllegalStateException: the bug")
        .contains("FaultyMain$Faulty.callStarL");
  }

  @Test
  void atTheTimeLimitTheProcessesSayWhatTheyWaitFor() throws IOException {
    LaunchResult result =
        run(DeadlockMain.class.getName(), DeadlockMain.plan(), Duration.ofSeconds(8));
    assertThat(result.errors()).as("%s", told).isEmpty();
    assertThat(result.run().unfinished()).hasSize(2);
    assertThat(result.run().diagnosis().cause())
        .isEqualTo("deadlock: robots wait in a circle: bot0 -> bot1 -> bot0");
    assertThat(result.run().diagnosis().lines())
        .anyMatch(line -> line.contains("bot0 waits for: both sections"))
        .anyMatch(line -> line.contains("mutex/left: holds [S]"))
        .anyMatch(line -> line.contains("mutex/right: requests [S]; answers missing from [bot1]"));
  }

  @Test
  void aProcessThatDoesNotStartEndsTheRun() throws IOException {
    LaunchResult result = run("org.starl.NoSuchProgram");
    assertThat(result.isGood()).isFalse();
    assertThat(result.errors()).hasSize(1);
    assertThat(result.errors().get(0)).contains("its process ended by itself, with status 1");
    assertThat(told).anyMatch(line -> line.contains("NoSuchProgram"));
  }
}
