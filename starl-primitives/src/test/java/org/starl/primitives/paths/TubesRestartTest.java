package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.world.Unsynced;

/** Programs that crash between the grant of a tube and the entry into it, and restart. */
class TubesRestartTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 6000, 6000);
  private static final long MS = 1_000_000;

  /** Goes to one place after every start of its program. */
  private static final class Traveller extends LogicThread {
    private final double goalMm;
    private final @Nullable Double givenMm;

    Traveller(GlobalVarHolder gvh) {
      this(gvh, 4500, null);
    }

    /**
     * @param rowMm null to stay in its row
     */
    Traveller(GlobalVarHolder gvh, double goalMm, @Nullable Double rowMm) {
      super(gvh);
      this.goalMm = goalMm;
      this.givenMm = rowMm;
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths =
          new DistributedPathPlanning(gvh, "floor", new OptimalPlanner(), FLOOR);
      await(gvh.gps::hasFix);
      double rowMm = givenMm == null ? gvh.gps.pose().yMm() : givenMm;
      paths.goTo(new ItemPosition("goal", goalMm, rowMm));
      await(() -> !paths.isUnderWay());
      return List.of(paths.tubeflag().get());
    }
  }

  /** Storage is slow: while a release is written, no other robot may know of it. */
  @Test
  void aTubeIsReleasedOnlyWhenThatIsWritten() {
    long held = 0;
    for (long atMs = 9_600; atMs <= 12_000; atMs += 200) {
      SimSettings settings =
          SimSettings.builder().set("stableDelay", "500ms").set("duration", "60s").build();
      RobotId first = new RobotId("bot0");
      Simulation.Builder builder =
          Simulation.builder()
              .seed(1)
              .settings(settings)
              .monitor(() -> new TubesSpec(600_000 * MS))
              .robot(new RobotSpec(first, new Pose(1000, 1500, 0), true, Traveller::new));
      builder.robot(
          new RobotSpec(
              new RobotId("bot1"),
              new Pose(1500, 4500, 0),
              true,
              gvh -> new Traveller(gvh, 2000, 1500.0)));
      // The two that stay up are a majority.
      builder.robot(
          new RobotSpec(new RobotId("bot2"), new Pose(5000, 5500, 0), true, Traveller::new));
      long crashMs = atMs;
      builder.director(control ->
          control.at(crashMs * MS, () -> control.crash(first, 8_000 * MS, Unsynced.LOST)));
      SimResult result = builder.build().run();
      assertThat(result.spec().violations()).as("crash at %d ms", atMs).isEmpty();
      held += result.spec().checks("tubes.Tubes");
    }
    assertThat(held).isGreaterThan(50);
  }

  @Test
  void aRestartedRobotWithTwoTubesContinues() {
    // Storage is so slow that a crash falls between the writes of the grant and of the release.
    for (long atMs = 500; atMs <= 2_300; atMs += 150) {
      SimSettings settings = SimSettings.builder().set("stableDelay", "300ms").build();
      Simulation.Builder builder =
          Simulation.builder()
              .seed(atMs)
              .settings(settings)
              .monitor(() -> new TubesSpec(600_000 * MS));
      for (int i = 0; i < 2; i++) {
        builder.robot(
            new RobotSpec(
                new RobotId("bot" + i), new Pose(1000, 1500 + 3000 * i, 0), true, Traveller::new));
      }
      long crashMs = atMs;
      builder.director(control ->
          control.at(
              crashMs * MS, () -> control.crash(new RobotId("bot0"), 500 * MS, Unsynced.LOST)));
      SimResult result = builder.build().run();
      assertThat(result.spec().violations()).as("crash at %d ms", atMs).isEmpty();
      assertThat(result.results().values())
          .as("crash at %d ms", atMs)
          .hasSize(2)
          .allMatch(ends -> ends.contains(TubeFlag.DONE));
    }
  }

  /** Returns the robots whose tubes a program does not know when it starts for the second time. */
  private static final class Observer extends LogicThread {
    Observer(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths =
          new DistributedPathPlanning(gvh, "floor", new OptimalPlanner(), FLOOR);
      if (gvh.id.boot() == 1) {
        await(() -> paths.unplaced().isEmpty());
        sleep(10_000);
      }
      return List.of(paths.unplaced(), paths.taken().size());
    }
  }

  @Test
  void aRestartedRobotKnowsTheTubesOfOthersBeforeItHearsFromThem() {
    RobotId second = new RobotId("bot1");
    SimResult result =
        Simulation.builder()
            .seed(1)
            .monitor(() -> new TubesSpec(600_000 * MS))
            .robot(new RobotSpec(new RobotId("bot0"), new Pose(1000, 1500, 0), true, Observer::new))
            .robot(new RobotSpec(second, new Pose(1000, 4500, 0), true, Observer::new))
            .director(control ->
                control.at(5_000 * MS, () -> control.crash(second, 500 * MS, Unsynced.LOST)))
            .build()
            .run();
    assertThat(result.results().get(second)).isEqualTo(List.of(List.of(), 1));
  }
}
