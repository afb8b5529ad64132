package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/** A drive that is stopped, or has failed, leaves nothing to the next one. One robot drives, one stands. */
class TubesStopTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 8000, 8000);
  private static final long DEADLINE_MS = 20_000;
  private static final TubeSettings TUBES =
      new TubeSettings(60, 1_000, DEADLINE_MS, 200, 2_000, 200, 2_000);
  private static final ItemPosition FREE = new ItemPosition("free", 2000, 3000);
  private static final ItemPosition TAKEN = new ItemPosition("taken", 5000, 1000);

  private static final class Robot extends LogicThread {
    private final BiConsumer<Robot, DistributedPathPlanning> part;

    Robot(GlobalVarHolder gvh, BiConsumer<Robot, DistributedPathPlanning> part) {
      super(gvh);
      this.part = part;
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths =
          new DistributedPathPlanning(
              gvh, "floor", gvh.id.participants(), new OptimalPlanner(), FLOOR, TUBES);
      await(() -> paths.isPlaced() && paths.unplaced().isEmpty());
      part.accept(this, paths);
      return List.of();
    }

    void pause(long ms) {
      sleep(ms);
    }

    /** How long the present drive takes. */
    long endsMs(DistributedPathPlanning paths) {
      long fromNs = gvh.plat.clock.nowNs();
      await(() -> !paths.isUnderWay());
      return (gvh.plat.clock.nowNs() - fromNs) / Time.NS_PER_MS;
    }

    double awayMm(ItemPosition place) {
      return gvh.gps.pose().distanceMm(place.at());
    }
  }

  private static void play(BiConsumer<Robot, DistributedPathPlanning> part) {
    Simulation.builder()
        .seed(1)
        .settings(SimSettings.builder().set("computeTime", "300ms").set("duration", "300s").build())
        .monitor(TubesSpec::new)
        .robot(
            new RobotSpec(
                new RobotId("bot0"), new Pose(1000, 1000, 0), true, gvh -> new Robot(gvh, part)))
        .robot(
            new RobotSpec(
                new RobotId("bot1"),
                new Pose(5000, 1000, 0),
                true,
                gvh -> new Robot(gvh, (robot, paths) -> robot.pause(200_000))))
        .build()
        .run();
  }

  /** At each of these times the drive is planned, or pauses after a refusal. */
  @ParameterizedTest
  @ValueSource(longs = {100, 1_000, 1_900, 3_300, 5_000, 7_300})
  void aDriveAfterOneThatWasStoppedGoesToItsOwnGoalAtOnce(long stopMs) {
    List<Object> ends = new ArrayList<>();
    play((robot, paths) -> {
      paths.goTo(TAKEN);
      robot.pause(stopMs);
      paths.stop();
      paths.goTo(FREE);
      ends.add(robot.endsMs(paths) < DEADLINE_MS);
      ends.add(paths.tubeflag().get());
      ends.add(robot.awayMm(FREE) < 200);
    });
    assertThat(ends).containsExactly(true, TubeFlag.DONE, true);
  }

  @Test
  void aPlanForADriveThatWasStoppedIsNotUsed() {
    List<Object> ends = new ArrayList<>();
    play((robot, paths) -> {
      paths.goTo(new ItemPosition("elsewhere", 1000, 5000));
      robot.pause(100);
      paths.stop();
      paths.goTo(FREE);
      robot.endsMs(paths);
      ends.add(paths.tubeflag().get());
      ends.add(robot.awayMm(FREE) < 200);
    });
    assertThat(ends).containsExactly(TubeFlag.DONE, true);
  }

  @Test
  void aDriveWithoutATubeFailsAtItsDeadlineAlsoInAPause() {
    List<Long> ends = new ArrayList<>();
    play((robot, paths) -> {
      for (int i = 0; i < 3; i++) {
        paths.goTo(TAKEN);
        ends.add(robot.endsMs(paths));
      }
    });
    assertThat(ends)
        .hasSize(3)
        .allSatisfy(ms -> assertThat(ms).isCloseTo(DEADLINE_MS, within(20L)));
  }
}
