package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimControl;
import org.starl.sim.SimResult;
import org.starl.sim.Simulation;
import org.starl.sim.world.Unsynced;

/** {@link DistributedPathPlanning#standHere}: a robot that will not go on gives its way back. */
class StandHereTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 8000, 8000);
  private static final RobotId LONG = new RobotId("bot0");
  private static final long S = 1_000_000_000;
  private static final TubeSettings PATIENT =
      new TubeSettings(60, 1_000, 60_000, 200, 2_000, 200, 2_000);

  /** bot0 drives around a wall, stops on its first leg, and stands; bot1 goes where it would have ended. */
  private static final class Robot extends LogicThread {
    private final boolean givesBack;

    Robot(GlobalVarHolder gvh, boolean givesBack) {
      super(gvh);
      this.givesBack = givesBack;
    }

    @Override
    public List<Object> callStarL() {
      DistributedPathPlanning paths =
          new DistributedPathPlanning(
              gvh, "floor", gvh.id.participants(), new OptimalPlanner(), FLOOR, PATIENT);
      await(gvh.gps::hasFix);
      if (!gvh.id.name().equals(LONG)) {
        sleep(12_000);
        paths.goTo(new ItemPosition("across", 6_400, 1_600));
        await(() -> !paths.isUnderWay());
        return List.of(paths.tubeflag().get());
      }
      if (gvh.id.boot() == 1) {
        paths.goTo(new ItemPosition("far", 6_500, 1_500));
        await(() -> paths.tubeflag().get() == TubeFlag.MOVING);
        assertThatThrownBy(paths::standHere).isInstanceOf(IllegalStateException.class);
        sleep(3_000);
        paths.stop();
        assertThat(paths.held().get(0).parts()).isGreaterThan(1);
        sleep(1_000);
      }
      if (givesBack) {
        await(paths::standHere);
        assertThat(paths.held()).hasSize(1).allMatch(tube -> tube.parts() == 1);
        assertThat(paths.standHere()).isTrue();
      }
      sleep(60_000);
      if (givesBack) {
        paths.goTo(new ItemPosition("on", 1_000, 6_000));
        await(() -> !paths.isUnderWay());
        assertThat(paths.tubeflag().get()).isEqualTo(TubeFlag.DONE);
      }
      return List.of(TubeFlag.IDLE);
    }
  }

  private static SimResult run(boolean givesBack, String crash) {
    Simulation.Builder builder =
        Simulation.builder()
            .seed(1)
            .obstacles(Obstacles.of(Obstacle.wall(new Point(4000, 0), new Point(4000, 5000))))
            .monitor(() -> new TubesSpec(600 * S))
            .director((SimControl control) -> {
              if (!crash.isEmpty()) {
                control.at(5 * S, () -> control.crash(LONG, 2 * S, Unsynced.valueOf(crash)));
              }
            });
    builder.robot(robot("bot0", new Pose(1500, 1500, 1.5), givesBack));
    builder.robot(robot("bot1", new Pose(7000, 3500, 0), givesBack));
    SimResult result = builder.build().run();
    assertThat(result.spec().holds()).as(result.spec().toString()).isTrue();
    return result;
  }

  private static RobotSpec robot(String name, Pose start, boolean givesBack) {
    return new RobotSpec(new RobotId(name), start, true, gvh -> new Robot(gvh, givesBack));
  }

  @ParameterizedTest
  @CsvSource({"true, DONE", "false, FAIL"})
  void anotherRobotPassesWhereTheRestOfItsTubeWas(boolean givesBack, TubeFlag end) {
    SimResult result = run(givesBack, "");
    assertThat(result.results().get(new RobotId("bot1"))).isEqualTo(List.of(end));
  }

  @ParameterizedTest
  @ValueSource(strings = {"LOST", "SOME", "KEPT"})
  void soDoesOneThatHasStartedAgain(String unsynced) {
    SimResult result = run(true, unsynced);
    assertThat(result.results().get(new RobotId("bot1"))).isEqualTo(List.of(TubeFlag.DONE));
  }
}
