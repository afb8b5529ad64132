package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
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

/** A robot stops as close as possible to another one, and the other one can still leave. */
class TubesDepartureTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 8000, 8000);
  private static final TubeSettings HASTY =
      new TubeSettings(60, 1_000, 20_000, 200, 2_000, 200, 2_000);
  private static final long BOUND_NS = 600_000_000_000L;

  /** The time when the first robot has stopped, and the time when the other must have left. */
  private static final long STOPPED_MS = 60_000;

  private static final long GONE_MS = 120_000;

  private abstract static class Driver extends LogicThread {
    Driver(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public final List<Object> callStarL() {
      DistributedPathPlanning paths =
          new DistributedPathPlanning(
              gvh, "floor", gvh.id.participants(), new OptimalPlanner(), FLOOR, HASTY);
      await(paths::isPlaced);
      drive(paths);
      await(() -> !paths.isUnderWay());
      return List.of(paths.tubeflag().get() + " " + paths.failure().get());
    }

    abstract void drive(DistributedPathPlanning paths);

    void sleepUntil(long atMs) {
      sleep(Math.max(0, atMs - gvh.plat.clock.nowNs() / 1_000_000));
    }
  }

  private static final class Stander extends Driver {
    Stander(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    void drive(DistributedPathPlanning paths) {
      sleepUntil(STOPPED_MS);
      paths.goTo(new ItemPosition("away", 1000, 7000));
    }
  }

  private static final class Passer extends Driver {
    Passer(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    void drive(DistributedPathPlanning paths) {
      paths.goTo(new ItemPosition("past", 6500, 4100));
      await(() -> gvh.gps.pose().xMm() > 3900);
      paths.stop();
      sleepUntil(GONE_MS);
      paths.goTo(new ItemPosition("past", 6500, 4100));
    }
  }

  @Test
  void aRobotCanLeaveBesideAStoppedOne() {
    Simulation.Builder builder =
        Simulation.builder()
            .seed(1)
            .settings(SimSettings.builder().set("duration", "300s").build())
            .monitor(() -> new TubesSpec(BOUND_NS));
    builder.robot(new RobotSpec(new RobotId("bot0"), new Pose(4000, 4000, 0), true, Stander::new));
    builder.robot(new RobotSpec(new RobotId("bot1"), new Pose(1500, 3900, 0), true, Passer::new));
    SimResult result = builder.build().run();
    assertThat(result.spec().violations()).isEmpty();
    assertThat(result.results().values())
        .as(String.valueOf(result.results()))
        .allMatch(ends -> ends.equals(List.of("DONE NONE")));
  }
}
