package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.Pose;
import org.starl.geometry.Rectangle;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimResult;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/** Reach tubes of 348 mm need starts 698 mm apart; the simulator's default is 462 mm. */
class TubeStartsTest {

  private static final Rectangle FLOOR = new Rectangle(0, 0, 5000, 3000);
  private static final int ROBOTS = 6;

  /** Waits until the others know its place: without a disc of its own it waits for ever. */
  private static final class Commuter extends LogicThread {
    private final DistributedPathPlanning paths;

    Commuter(GlobalVarHolder gvh) {
      super(gvh);
      paths = new DistributedPathPlanning(gvh, "floor", new OptimalPlanner(), FLOOR);
    }

    @Override
    public List<Object> callStarL() {
      await(paths::isPlaced);
      return List.of(gvh.gps.pose().at());
    }
  }

  /** Creates its tubes after the first fix. */
  private static final class LateCommuter extends LogicThread {
    LateCommuter(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      await(gvh.gps::hasFix);
      return List.of(
          new DistributedPathPlanning(gvh, "floor", new OptimalPlanner(), FLOOR).isPlaced());
    }
  }

  private static Simulation.Builder drawn(
      long seed, Function<GlobalVarHolder, ? extends LogicThread> app) {
    return timed().seed(seed).robots(ROBOTS, app);
  }

  private static Simulation.Builder timed() {
    return Simulation.builder().settings(with("duration", "60s"));
  }

  private static SimSettings with(String key, String value) {
    return SimSettings.builder().set("duration", "60s").set(key, value).build();
  }

  private static RobotSpec at(int i, double xMm) {
    return new RobotSpec(new RobotId("bot" + i), new Pose(xMm, 1500, 0), true, Commuter::new);
  }

  @Test
  void drawnStartsAreFarEnoughApartForTubes() {
    for (long seed = 1; seed <= 20; seed++) {
      SimResult result = drawn(seed, Commuter::new).build().run();
      assertThat(result.isFinished()).as("seed %s: %s", seed, result.diagnosis()).isTrue();
    }
  }

  @Test
  void theNeedOfTheProgramsDecidesHowManyFit() {
    assertThatThrownBy(() -> timed().robots(40, Commuter::new).seed(1).build().run())
        .isInstanceOf(BadInput.class)
        .hasMessageMatching(
            "robots: 40: only [0-9]+ found places 698 mm apart on a floor of 5000 by 3000 mm:.*");
  }

  @Test
  void givenStartsThatAreTooNearAreRefusedWithBothNumbers() {
    Simulation.Builder near = timed().robot(at(0, 1000)).robot(at(1, 1600));
    assertThatThrownBy(() -> near.build().run())
        .isInstanceOf(BadInput.class)
        .hasMessage("bot0 and bot1 start 600 mm apart: expected at least 698 mm for reach tubes");
    Simulation.Builder far = timed().robot(at(0, 1000)).robot(at(1, 1700));
    assertThat(far.build().run().isFinished()).isTrue();
  }

  @Test
  void positionErrorsNeedRoomOfTheirOwn() {
    SimSettings noisy = with("positionNoise", "10mm");
    Simulation.Builder near = timed().settings(noisy).robot(at(0, 1000)).robot(at(1, 1717));
    assertThatThrownBy(() -> near.build().run())
        .isInstanceOf(BadInput.class)
        .hasMessage(
            "bot0 and bot1 start 717 mm apart: expected at least 698 mm for reach tubes"
                + " and 20 mm for positionNoise");
    for (long seed = 1; seed <= 20; seed++) {
      Simulation.Builder far = timed().settings(noisy).robot(at(0, 1000)).robot(at(1, 1718));
      assertThat(far.seed(seed).build().run().isFinished()).as("seed %s", seed).isTrue();
      SimResult drawn = drawn(seed, Commuter::new).settings(noisy).build().run();
      assertThat(drawn.isFinished()).as("seed %s: %s", seed, drawn.diagnosis()).isTrue();
    }
  }

  @Test
  void aGivenSpacingThatIsTooSmallIsRefusedWithBothNumbers() {
    Simulation.Builder near = drawn(1, Commuter::new).settings(with("startSpacing", "3"));
    assertThatThrownBy(() -> near.build().run())
        .isInstanceOf(BadInput.class)
        .hasMessageMatching(
            "bot. and bot. start 5.. mm apart: expected at least 698 mm for reach tubes:"
                + " startSpacing=3, expected at least 4.24");
  }

  @Test
  void startsCannotMoveAfterTheFirstFix() {
    assertThatThrownBy(() -> drawn(1, LateCommuter::new).build().run())
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("expected at least 698 mm for reach tubes: startSpacing=2.8");
  }

  @Test
  void noiseAboveTheErrorOfTubesIsRefusedWithBothNumbers() {
    Simulation.Builder noisy = drawn(1, Commuter::new).settings(with("positionNoise", "61mm"));
    assertThatThrownBy(() -> noisy.build().run())
        .isInstanceOf(BadInput.class)
        .hasMessage("positionNoise=61mm: expected at most 60mm for reach tubes");
  }

  @Test
  void aDelayLongerThanTheDeadlineOfTubesIsRefusedWithBothNumbers() {
    Simulation.Builder late = drawn(1, Commuter::new).settings(with("messageDelay", "30s"));
    assertThatThrownBy(() -> late.build().run())
        .isInstanceOf(BadInput.class)
        .hasMessage(
            "messageDelay=30s, stableDelay=0ms, computeTime=0ms: an answer takes at least 60s,"
                + " expected less than 60s for reach tubes");
  }
}
