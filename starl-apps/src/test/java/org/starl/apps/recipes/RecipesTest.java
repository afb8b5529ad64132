package org.starl.apps.recipes;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFlag;
import org.starl.primitives.agreement.AgreementSpec;
import org.starl.primitives.barrier.BarrierSpec;
import org.starl.primitives.election.ElectionSpec;
import org.starl.primitives.geocast.GeocastSpec;
import org.starl.primitives.ledger.LedgerSpec;
import org.starl.primitives.motion.MotionSpec;
import org.starl.primitives.mutex.MutexSpec;
import org.starl.primitives.paths.TubeFailure;
import org.starl.primitives.paths.TubeFlag;
import org.starl.primitives.paths.TubesSpec;
import org.starl.primitives.registration.RegistrationSpec;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.spec.Monitor;

/** What docs/primitives.md and docs/from-the-first-starl.md show runs, and keeps its specification. */
class RecipesTest {

  private static Simulation.Builder robots(
      Function<GlobalVarHolder, LogicThread> app, Pose... starts) {
    Simulation.Builder builder =
        Simulation.builder()
            .name("recipe")
            .settings(SimSettings.builder().messageLoss(0.1).build());
    for (int i = 0; i < starts.length; i++) {
      builder.robot(new RobotSpec(new RobotId("bot" + i), starts[i], true, app));
    }
    return builder;
  }

  private static Simulation.Builder four(Function<GlobalVarHolder, LogicThread> app) {
    return robots(
        app,
        new Pose(500, 500, 0),
        new Pose(1_500, 500, 0),
        new Pose(500, 1_500, 0),
        new Pose(4_500, 2_500, 0));
  }

  private static Collection<List<Object>> results(
      Simulation.Builder builder, Supplier<? extends Monitor> spec) {
    SimResult result = builder.seed(7).monitor(spec).build().run();
    assertThat(result.isFinished()).as("%s", result.unfinished()).isTrue();
    assertThat(result.spec().holds()).as("%s", result.spec()).isTrue();
    return result.results().values();
  }

  @Test
  void messages() {
    // The chief hears itself, too.
    assertThat(results(four(MessagesRecipe::new), TubesSpec::new))
        .containsExactly(List.of(true, 4), List.of(true, 3), List.of(true, 3), List.of(true, 3));
  }

  @Test
  void mutex() {
    assertThat(results(four(MutexRecipe::new), MutexSpec::new)).containsOnly(List.of("used"));
  }

  @Test
  void sequence() {
    assertThat(results(four(SequenceRecipe::new), MutexSpec::new)).containsOnly(List.of("used"));
  }

  @Test
  void lane() {
    assertThat(results(four(LaneRecipe::new), () -> new MutexSpec().withModes()))
        .containsOnly(List.of("through"));
  }

  @Test
  void registration() {
    assertThat(results(four(RegistrationRecipe::new), RegistrationSpec::new))
        .containsOnly(List.of(true, true));
  }

  @Test
  void geocast() {
    Collection<List<Object>> heard = results(four(GeocastRecipe::new), GeocastSpec::new);
    assertThat(heard)
        .extracting(list -> list.stream().sorted().toList().toString())
        .containsExactly(
            "[bot1 brakes, bot2 brakes]",
            "[bot0 brakes, bot2 brakes]",
            "[bot0 brakes, bot1 brakes]",
            "[]");
  }

  @Test
  void broadcast() {
    assertThat(results(four(BroadcastRecipe::new), GeocastSpec::new))
        .allSatisfy(heard -> assertThat(heard).hasSize(4).contains("3 have it"));
  }

  @Test
  void election() {
    assertThat(results(four(ElectionRecipe::new), ElectionSpec::new).stream().distinct())
        .hasSize(1);
  }

  @Test
  void barrier() {
    assertThat(results(four(BarrierRecipe::new), BarrierSpec::new))
        .containsOnly(List.of("three phases"));
  }

  @Test
  void ledger() {
    Simulation.Builder crashed = four(LedgerRecipe::new).fault("crash(bot1,at=2s,restart=1s)");
    List<Object> done =
        results(crashed, LedgerSpec::new).stream().flatMap(List::stream).sorted().toList();
    assertThat(done).doesNotHaveDuplicates().hasSizeBetween(5, 6); // bot1 forgets what it has done
  }

  @Test
  void persistent() {
    Simulation.Builder crashed =
        four(PersistentRecipe::new).fault("crash(all,at=2500ms,restart=1s,lose=unsynced)");
    assertThat(results(crashed, TubesSpec::new)).containsOnly(List.of("program 2: 5 rooms"));
  }

  @Test
  void agreement() {
    Collection<List<Object>> colours = results(four(AgreementRecipe::new), AgreementSpec::new);
    assertThat(colours.stream().distinct()).hasSize(1);
    assertThat(colours)
        .allSatisfy(c -> assertThat(c).asString().matches("\\[the colour of bot[0-3]]"));
  }

  @Test
  void motion() {
    assertThat(results(robots(MotionRecipe::new, new Pose(500, 1_500, 0)), MotionSpec::new))
        .containsExactly(List.of(MotionFlag.DONE, ""));
  }

  @Test
  void planning() {
    Obstacles wall =
        Obstacles.NONE.plus(Obstacle.wall(new Point(2_500, 1_000), new Point(2_500, 3_000)));
    Simulation.Builder builder =
        robots(PlanningRecipe::new, new Pose(500, 1_500, 0)).obstacles(wall);
    assertThat(results(builder, MotionSpec::new))
        .hasSize(1)
        .allSatisfy(ended -> {
          assertThat((Integer) ended.get(0)).isGreaterThan(1);
          assertThat(ended.get(1)).isEqualTo(MotionFlag.DONE);
        });
  }

  @Test
  void tubes() {
    Pose left = new Pose(500, 1_500, 0);
    Pose right = new Pose(4_500, 1_500, 0);
    Simulation.Builder builder =
        robots(TubesRecipe::new, left, right)
            .waypoints(
                List.of(
                    new ItemPosition("goal of bot0", 4_500, 2_500),
                    new ItemPosition("goal of bot1", 500, 500)));
    assertThat(results(builder, TubesSpec::new))
        .hasSize(2)
        .containsOnly(List.of(TubeFlag.DONE, TubeFailure.NONE));
  }

  @Test
  void positionsAndWaypoints() {
    Simulation.Builder builder =
        four(PositionsRecipe::new).waypoints(List.of(new ItemPosition("dock", 4_000, 2_000)));
    assertThat(results(builder, MotionSpec::new)).containsOnly(List.of(new RobotId("bot3")));
  }
}
