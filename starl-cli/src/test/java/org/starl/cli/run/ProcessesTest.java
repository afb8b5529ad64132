package org.starl.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.Demo;
import org.starl.apps.Plan;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.cli.Cli;
import org.starl.cli.command.Apps;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.request.RunRequest;
import org.starl.launch.Kill;
import org.starl.launch.LaunchResult;
import org.starl.launch.LaunchSettings;
import org.starl.launch.Launcher;
import org.starl.sim.SimulationPlan;

/** {@code starl run --processes}: robots that are processes of this machine, in real time. */
@Tag("realtime")
class ProcessesTest {

  private static final long LIMIT_S = 60;

  @TempDir private Path folder;

  private String[] hello(String... more) {
    List<String> words =
        new ArrayList<>(List.of("run", "hello", "--processes", "--robots", "2", "--seed", "3"));
    words.addAll(List.of("--png", folder.resolve("a.png").toString()));
    words.addAll(List.of(more));
    return words.toArray(String[]::new);
  }

  @Test
  void aKillIsReportedAndTheOtherRobotGoesOn() {
    Cli cli = Cli.run(hello("--kill", "bot0@motion.motionflag=MOVING"));
    assertThat(cli.status()).as("%s", cli).isZero();
    assertThat(cli.text())
        .contains("bot1: DONE", "bot0's process ", " was killed at ", "as requested", "safe: ")
        .contains("2 processes came 1 time to the end");
    assertThat(cli.err()).anyMatch(line -> line.startsWith("bot0 is process "));
  }

  @Test
  void noRobotSurvivesItsParent() throws Exception {
    List<String> command = new ArrayList<>(Cli.process(hello()));
    // A parent that is killed leaves its temporary folder.
    command.add(1, "-Djava.io.tmpdir=" + folder);
    Process parent = new ProcessBuilder(command).start();
    List<ProcessHandle> robots = new ArrayList<>();
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(parent.getErrorStream(), StandardCharsets.UTF_8))) {
      for (int robot = 0; robot < 2; robot++) {
        String line = lines.readLine();
        assertThat(line).startsWith("bot" + robot + " is process ");
        ProcessHandle.of(Long.parseLong(line.substring(line.lastIndexOf(' ') + 1)))
            .ifPresent(robots::add);
      }
    }
    parent.destroyForcibly();
    for (ProcessHandle robot : robots) {
      assertThat(robot.onExit().get(LIMIT_S, TimeUnit.SECONDS).isAlive()).isFalse();
    }
  }

  /** Two cars of the paper need the same zones; the first one inside is killed there. */
  @Test
  void noCarEntersTheZonesOfAKilledCar() throws Exception {
    List<String> words =
        List.of(
            "intersection",
            "--seed",
            "1",
            "--robots",
            "2",
            "--loss",
            "0.2",
            "--set",
            "debris=0",
            "--set",
            "car=paper");
    Plan plan = plan();
    SimulationPlan simulation = plan.simulation().build().plan();
    LaunchSettings settings =
        new LaunchSettings(
            1,
            List.of(
                Kill.parse("bot0@app.location=MOVE_WAIT+2500ms"),
                Kill.parse("bot1@app.location=MOVE_WAIT+2500ms")),
            Duration.ofSeconds(200),
            Duration.ofSeconds(3));
    List<String> lines = new ArrayList<>();
    LaunchResult result;
    try (Launcher launcher =
        new Launcher(
            simulation,
            ProcessOptions.command(words),
            CrossingFact.FIGURE_4,
            settings,
            lines::add)) {
      result = launcher.run();
    }
    assertThat(result.isGood()).as("%s %s", result, lines).isTrue();
    assertThat(result.deaths()).hasSize(1);
    assertThat(result.run().unfinished()).hasSize(1);
    assertThat(result.run().spec().checks("intersection.traffic_safety")).isGreaterThan(100);
    assertThat(ProcessOutcome.lines(result))
        .anyMatch(line -> line.contains("is alive but not finished: it waits for zones that bot"))
        .anyMatch(line -> line.startsWith("safe: "));
    assertThat(plan.story().lines()).anyMatch(line -> line.contains(", still waits for ["));
    assertThat(plan.story().lines()).anyMatch(line -> line.contains(", crashed at "));
  }

  /** The same as the options of the test above. */
  private static Plan plan() {
    Demo demo = Apps.OWN.byName("intersection").orElseThrow();
    return new RunRequest.Builder(demo)
        .set("", "robots", "2")
        .set("", "debris", "0")
        .set("", "car", "paper")
        .set("", "messageLoss", "0.2")
        .build()
        .plan(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "run hello --rounds 2 | --rounds needs --processes",
        "run hello --kill bot0@2s | --kill needs --processes",
        "run hello --processes --kill bot0 | --kill: 'bot0': expected ROBOT@WHEN",
        "run hello --processes --kill bot9@2s | --kill: 'bot9@2s': expected one of [bot0",
        "run hello --processes --rounds 0 | --rounds: ",
        "run hello --processes --fault stuck(bot0,at=2s) | expected crash(NAME,at=TIME)",
        "run hello --processes --fault crash(bot0,at=2s,restart=1s) | without restart",
        "run hello --processes --chaos | --chaos cannot ",
      })
  void optionsWithoutEffectOnProcessesAreRefused(String line, String expected) {
    List<String> words = new ArrayList<>(List.of(line.split(" ")));
    words.addAll(List.of("--png", folder.resolve("a.png").toString()));
    Cli cli = Cli.run(words.toArray(String[]::new));
    assertThat(cli.status()).as("%s", cli).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(cli.err()).hasSize(1);
    assertThat(cli.err().get(0)).contains(expected);
  }
}
