package org.starl.cli.deploy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.primitives.paths.DistributedPathPlanning;
import org.starl.primitives.paths.OptimalPlanner;
import org.starl.robot.RealMotion;
import org.starl.robot.file.Limits;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** A deployment and a simulation with its values have the same starts, settings and refusals. */
class AsDeployedTest {

  /** Stays where it is, in a reach tube. */
  private static final class Waiter extends LogicThread {
    private final DistributedPathPlanning paths;

    Waiter(GlobalVarHolder gvh) {
      super(gvh);
      paths =
          new DistributedPathPlanning(
              gvh, "floor", new OptimalPlanner(), new Rectangle(0, 0, 9000, 9000));
    }

    @Override
    public List<Object> callStarL() {
      await(paths::isPlaced);
      return List.of();
    }
  }

  /** Robots in reach tubes, at starts that the app gives, or that are drawn. */
  private record Tubes(String name, double apartMm) implements Demo {
    @Override
    public String summary() {
      return "robots in tubes";
    }

    @Override
    public Plan plan(Request request, SimSettings settings) {
      Simulation.Builder simulation = Simulation.builder().settings(settings);
      int robots = request.robots().orElse(settings.robots());
      if (apartMm == 0) {
        return Plan.of(simulation.robots(robots, Waiter::new));
      }
      for (int i = 0; i < robots; i++) {
        Pose start = new Pose(500 + apartMm * i, 500, 0);
        simulation.robot(new RobotSpec(new RobotId("bot" + i), start, true, Waiter::new));
      }
      return Plan.of(simulation);
    }
  }

  private static final Demos DEMOS =
      new Demos(List.of(new Tubes("near", 820), new Tubes("far", 940), new Tubes("drawn", 0)));

  @TempDir private Path folder;

  private String deployment(String app, String more) throws IOException {
    Path file = folder.resolve("my.yaml");
    Files.writeString(
        file,
        """
        app: APP
        network: {broadcasts: no}
        positions: {source: natnet, server: 127.0.0.1}
        robots:
          bot0: {address: "127.0.0.1:4748", chassis: {kind: create, port: tty0}}
          bot1: {address: "127.0.0.1:4749", chassis: {kind: create, port: tty1}}
        """
                .replace("APP", app)
            + more);
    return file.toString();
  }

  private Cli run(String app, String file, String... more) {
    String png = folder.resolve("run.png").toString();
    return Cli.line(
        DEMOS, "run " + app + " --seed 1 --as-deployed " + file + " --png " + png, (Object[]) more);
  }

  @Test
  void startsAtWhichNoRobotCanMoveAreRefusedEverywhere() throws IOException {
    String file = deployment("near", "");
    String says = "bot0 and bot1 start 820 mm apart: expected at least 922 mm for reach tubes";

    Cli.line(DEMOS, "deploy check", file).assertRefused("my.yaml:1: " + says);
    Cli.line(DEMOS, "deploy run", file, "--robot", "bot0").assertRefused("my.yaml:1: " + says);
    run("near", file).assertRefused(says);
    assertThat(Cli.line(DEMOS, "run near --seed 1 --png", folder.resolve("a.png")).status())
        .as("the simulator's own defaults are exact")
        .isZero();
  }

  @Test
  void startsThatAreFarEnoughApartPass() throws IOException {
    String file = deployment("far", "");

    Cli check = Cli.line(DEMOS, "deploy check", file);
    assertThat(check.status()).as("%s", check).isZero();
    assertThat(check.text()).contains("simulated for 20 s", "0 of 2 moved");
    assertThat(run("far", file).status()).isZero();
  }

  @Test
  void theLimitsDecideHowFarApart() throws IOException {
    String slow = deployment("near", "limits: {speedMmPerS: 130}\n");

    assertThat(Cli.line(DEMOS, "deploy check", slow).status()).isZero();
    Cli run = run("near", slow);
    assertThat(run.status()).as("%s", run).isZero();
  }

  @Test
  void drawnStartsAreThoseOfTheRealFloorAndAreNotDrawnAgain() throws IOException {
    String file = deployment("drawn", "parameters: {floorWidth: 1200mm, floorHeight: 700mm}\n");

    Cli.line(DEMOS, "deploy check", file)
        .assertRefused("bot0 and bot1 start", "at least 922 mm", "startSpacing=2.8", "5.65");
    run("drawn", file).assertRefused("bot0 and bot1 start", "startSpacing=2.8");
  }

  @Test
  void positionErrorsNeedRoomToo() throws IOException {
    String coarse = deployment("far", "");
    Files.writeString(
        Path.of(coarse), Files.readString(Path.of(coarse)).replace(".0.1}", ".0.1, errorMm: 12}"));
    Cli.line(DEMOS, "deploy check", coarse)
        .assertRefused("940 mm apart: expected at least 922 mm for reach tubes and 24 mm for");
  }

  @Test
  void optionsReplaceTheDeployment() throws IOException {
    String file = deployment("near", "");

    Cli exact = run("near", file, "--set", "reaction=0ms", "--set", "speedError=0");
    assertThat(exact.status()).as("%s", exact).isZero();
  }

  @Test
  void anotherAppTakesTheLimitsAndErrorsOnly() throws IOException {
    String file = deployment("far", "parameters: {robotRadius: 100mm}\n");

    run("near", file, "--robots", "3")
        .assertRefused("bot0 and bot1 start 820 mm apart: expected at least 922 mm");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "speedError: 0.05|speedError: '0.05': expected 0.1",
        "reaction: 100ms|reaction: '100ms': expected 200ms",
        "positionNoise: 1cm|positionNoise: '1cm': expected 5mm",
      })
  void aParameterThatContradictsTheDeploymentIsRefused(String line) throws IOException {
    String[] parts = line.split("[|]");
    String file = deployment("far", "parameters: {" + parts[0] + "}\n");

    Cli.line(DEMOS, "deploy check", file).assertRefused("my.yaml:7: " + parts[1]);
    run("far", file).assertRefused("my.yaml:7: " + parts[1]);
  }

  @Test
  void aParameterThatSaysTheSameIsTaken() throws IOException {
    String same = "parameters: {speedError: 0.10, reaction: 0.2s, robots: 2}\n";
    assertThat(Cli.line(DEMOS, "deploy check", deployment("far", same)).status()).isZero();
  }

  @ParameterizedTest
  @ValueSource(doubles = {30, 180, 300, 500})
  void theSimulatorsRobotsDriveAsTheRealOnes(double mmPerS) {
    SimSettings settings =
        SimSettings.builder()
            .set("maxSpeed", mmPerS + "mm/s")
            .set("speedError", "0.1")
            .set("reaction", "200ms")
            .build();

    assertThat(settings.motionParameters(0))
        .isEqualTo(
            RealMotion.of(
                SimSettings.defaults().motionParameters(0),
                new Limits(mmPerS, 300, 500, 0.1, 200)));
  }
}
