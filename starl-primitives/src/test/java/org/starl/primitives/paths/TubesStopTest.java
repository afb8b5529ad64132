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
import org.starl.body.MotionParameters;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/** What each call of a drive does, and that it leaves nothing to the next one. One robot drives, one stands. */
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

    GlobalVarHolder gvh() {
      return gvh;
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

  private static final Path UP =
      new Path(List.of(new Point(1000, 1000), new Point(1000, 2000), new Point(2000, 3000)));

  @Test
  void aGivenPathIsDrivenAsItIsAndTheNextGoalIsPlanned() {
    List<Object> ends = new ArrayList<>();
    List<List<Point>> tubes = new ArrayList<>();
    play((robot, paths) -> {
      paths.goAlong(UP);
      robot.pause(4_000);
      paths.held().forEach(tube -> tubes.add(tube.points()));
      robot.endsMs(paths);
      ends.add(paths.tubeflag().get());
      ends.add(robot.awayMm(FREE) < 100);
      ItemPosition back = new ItemPosition("back", 1000, 1000);
      paths.goTo(back);
      robot.endsMs(paths);
      ends.add(paths.tubeflag().get());
      ends.add(robot.awayMm(back) < 100);
    });
    assertThat(ends).containsExactly(TubeFlag.DONE, true, TubeFlag.DONE, true);
    assertThat(tubes)
        .singleElement()
        .satisfies(points -> {
          assertThat(points.get(0)).isEqualTo(UP.start());
          assertThat(points).contains(new Point(1000, 2000)).endsWith(new Point(2000, 3000));
        });
  }

  @Test
  void aGivenPathIntoAnotherTubeFailsAtItsDeadline() {
    List<Object> ends = new ArrayList<>();
    play((robot, paths) -> {
      paths.goAlong(new Path(List.of(new Point(1000, 1000), TAKEN.at())));
      ends.add(Math.abs(robot.endsMs(paths) - DEADLINE_MS) < 20);
      ends.add(paths.failure().get());
      ends.add(robot.awayMm(TAKEN) > 3_900);
    });
    assertThat(ends).containsExactly(true, TubeFailure.DEADLINE, true);
  }

  @Test
  void aGivenPathBeginsAtTheRobot() {
    List<Object> ends = new ArrayList<>();
    play((robot, paths) -> {
      double nearMm = 60 + robot.gvh().plat.moat.parameters().goalRadiusMm();
      double errorMm = robot.gvh().gps.errorMm();
      for (double offMm : new double[] {nearMm - errorMm - 1, nearMm - errorMm + 1}) {
        Path path = new Path(List.of(new Point(1000 + offMm, 1000), new Point(2000, 3000)));
        ends.add(isRefused(() -> paths.goAlong(path)));
        paths.stop();
      }
    });
    assertThat(ends).containsExactly(false, true);
  }

  private static boolean isRefused(Runnable call) {
    try {
      call.run();
      return false;
    } catch (IllegalArgumentException | IllegalStateException e) {
      return true;
    }
  }

  @Test
  void oneCallAtATimeAndNoneAfterTheEnd() {
    List<Object> ends = new ArrayList<>();
    play((robot, paths) -> {
      ends.add(isRefused(() -> paths.goTo(FREE)));
      ends.add(isRefused(() -> paths.goTo(FREE)));
      ends.add(isRefused(() -> paths.goAlong(UP)));
      ends.add(isRefused(paths::standHere));
      robot.pause(6_000);
      ends.add(paths.tubeflag().get());
      ends.add(isRefused(paths::standHere));
      paths.close();
      ends.add(paths.failure().get());
      ends.add(robot.gvh().plat.moat.inMotion());
      ends.add(isRefused(() -> paths.goTo(FREE)));
      ends.add(isRefused(paths::standHere));
      robot.pause(2_000);
      double fromMm = robot.awayMm(FREE);
      robot.pause(10_000);
      ends.add(robot.awayMm(FREE) == fromMm);
    });
    assertThat(ends)
        .containsExactly(
            false,
            true,
            true,
            true,
            TubeFlag.MOVING,
            true,
            TubeFailure.STOPPED,
            false,
            true,
            true,
            true);
  }

  @Test
  void aTubeOfASlowRobotIsNarrowerByWhatItDrivesUntilItsNextCommand() {
    MotionParameters fast = MotionParameters.builder().reactionMs(500).build();
    MotionParameters slow = DistributedPathPlanning.slowed(fast, 20);
    assertThat(slow.linSpeedMaxMmPerS()).isLessThan(fast.linSpeedMaxMmPerS());
    assertThat(slow.linSpeedMinMmPerS()).isLessThanOrEqualTo(slow.linSpeedMaxMmPerS());
    assertThat(slow.arcSpeedMaxMmPerS()).isLessThanOrEqualTo(slow.linSpeedMaxMmPerS());
    assertThat(Tracking.stepS(fast) * slow.linSpeedMaxMmPerS()).isCloseTo(20, within(1e-9));
    assertThat(DistributedPathPlanning.slowed(fast, 1e9)).isEqualTo(fast);
    int own = DistributedPathPlanning.radiusMm(slow, TUBES);
    assertThat(own).isLessThan(DistributedPathPlanning.radiusMm(fast, TUBES));
    assertThat(DistributedPathPlanning.radiusMm(fast, TUBES, 20)).isGreaterThanOrEqualTo(own);
    MotionParameters exact = MotionParameters.DEFAULT;
    assertThat(DistributedPathPlanning.radiusMm(exact, TUBES, 20))
        .isEqualTo(DistributedPathPlanning.radiusMm(exact, TUBES));
  }
}
